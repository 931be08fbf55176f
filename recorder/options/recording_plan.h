#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace millwear::recorder {

/// How a measurement goes on while its load is not known well enough.
struct GoingOn {
  double target_error;  ///< relative, of the smoothed rate of loss at its peaks
  long by_steps;        ///< at a time
  long at_most;         ///< the last step it may reach
};

/// What the recorder is to do, from its command line.
struct RecordingPlan {
  std::filesystem::path deck;                   ///< LIGGGHTS's input script
  std::filesystem::path mill;                   ///< the case file
  std::filesystem::path liner;                  ///< the profile that the deck's mesh follows
  std::filesystem::path load;                   ///< to be written
  std::optional<std::filesystem::path> events;  ///< to be written, a row a collision
  long first_step;                              ///< the measurement takes the steps after it
  long last_step;                               ///< ... up to this one, at least
  long every_steps;                             ///< between two samples
  std::optional<long> pairs_after;              ///< collisions between particles from here on,
                                                ///< up to `last_step`
  std::optional<GoingOn> going_on;
};

/// Whether a step is sampled: the last one, and those that lie a multiple of `every_steps` after
/// the first. So every sample stands for the steps since the one before, and all of them for all
/// steps.
[[nodiscard]] bool is_sampled(const RecordingPlan& plan, long step);

/// Samples after step `from` up to step `to`, where a piece of the measurement ends.
[[nodiscard]] long samples_between(const RecordingPlan& plan, long from, long to);

/// Throws Failure (usage) for an option that is unknown, missing or no number, and for steps that
/// do not fit.
[[nodiscard]] RecordingPlan recording_plan(const std::vector<std::string>& arguments);

/// The text of --help.
[[nodiscard]] std::string recording_help();

}  // namespace millwear::recorder
