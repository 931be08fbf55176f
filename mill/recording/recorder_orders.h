#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/load/steady_mixing.h"
#include "mill/recording/recorder_option.h"

namespace millwear {

/// What millwear-recorder is told to do, and how that is written as the words of its command line.
/// The recorder reads the words back in recorder/options/. Each `for_each_option` is the one table
/// of an order's options.

/// The first word of an order that does not record.
inline constexpr const char* mixing_verb = "mix";
inline constexpr const char* running_verb = "run";

inline constexpr RecorderOption deck_option{
    .name = "--in", .help = "LIGGGHTS's input script", .short_name = "-i"};

inline constexpr RecorderOption columns_option{
    .name = "--columns",
    .help =
        "so many columns of ranks along x (the script's `processors`) get equally many "
        "particles before every `run`",
    .need = OptionNeed::optional,
    .range = OptionRange::positive};

/// How a measurement goes on while its load is not known well enough.
struct GoingOn {
  double target_error;  ///< relative, of the smoothed rate of loss at its peaks
  long by_steps;        ///< at a time
  long at_most;         ///< the last step it may reach
  bool operator==(const GoingOn&) const = default;
};

/// Run a deck and record its wall contacts.
struct RecordingPlan {
  std::filesystem::path deck;                        ///< LIGGGHTS's input script
  std::filesystem::path mill;                        ///< the case file
  std::filesystem::path liner;                       ///< the profile that the deck's mesh follows
  std::filesystem::path load;                        ///< to be written
  std::optional<std::filesystem::path> events;       ///< to be written, a row a collision
  std::optional<std::filesystem::path> charge = {};  ///< to be written, how the charge looked
  long first_step;                                   ///< the measurement takes the steps after it
  long last_step;                                    ///< ... up to this one, at least
  long every_steps = 1;                              ///< between two samples
  std::optional<long> pairs_after;                   ///< collisions between particles from here on,
                                                     ///< up to `last_step`
  std::optional<GoingOn> going_on;
  /// Of a part of a measurement: the steps that parts before it have measured, and those by which
  /// the time blocks of the whole are laid.
  std::optional<long> measured_before = {};
  std::optional<long> block_steps = {};
  std::optional<long> columns = {};  ///< of ranks along x, to be balanced
  bool operator==(const RecordingPlan&) const = default;
};

/// Whether a step is sampled: the last one, and those that lie a multiple of `every_steps` after
/// the first. So every sample stands for the steps since the one before, and all of them for all
/// steps.
[[nodiscard]] bool is_sampled(const RecordingPlan& plan, long step);

/// Steps of the whole measurement that are measured before step `step` of this part.
[[nodiscard]] long measured_until(const RecordingPlan& plan, long step);

/// Steps of the measurement over which the case's number of time blocks is laid. It is longer than
/// that where it goes on, by whole blocks.
[[nodiscard]] long steps_of_blocks(const RecordingPlan& plan);

/// Samples after step `from` up to step `to`, where a piece of the measurement ends.
[[nodiscard]] long samples_between(const RecordingPlan& plan, long from, long to);

/// The options of a measurement that goes on: all of them or none.
struct GoingOnOptions {
  std::optional<double> target_error;
  std::optional<long> by_steps;
  std::optional<long> at_most;
};

/// Calls `take` with every option of a recording and the value that it tells.
template <class Take>
void for_each_option(RecordingPlan& plan, GoingOnOptions& going_on, const Take& take) {
  using enum OptionNeed;
  using enum OptionRange;
  take(deck_option, plan.deck);
  take({"--case", "the case file of the mill"}, plan.mill);
  take({"--liner", "profile (CSV) that the script's mesh follows"}, plan.liner);
  take({"--load", "file to write: the load on the liner (HDF5)"}, plan.load);
  take({"--events", "file to write: a row a collision (HDF5)", optional}, plan.events);
  take({"--charge", "file to write: how the charge looked (HDF5)", optional}, plan.charge);
  take({"--after", "the measurement begins after this step", required, not_negative},
       plan.first_step);
  take({"--until", "... and ends with this step", required, positive}, plan.last_step);
  take({"--every", "steps between two samples of the wall contacts", optional, positive},
       plan.every_steps);
  take({"--pairs-after",
        "record collisions between particles after this step; a `run` of the script has to begin "
        "there",
        optional},
       plan.pairs_after);
  take({"--target-error",
        "go on after --until, while the relative standard error of the smoothed rate of loss at "
        "its peaks is above this",
        optional, positive},
       going_on.target_error);
  take({"--go-on-by", "... by so many steps at a time", optional, positive}, going_on.by_steps);
  take({"--at-most", "... and not beyond this step", optional, positive}, going_on.at_most);
  take({"--measured-before",
        "this is a part of a measurement, after so many of its steps; with --block-steps", optional,
        not_negative},
       plan.measured_before);
  take({"--block-steps", "... and the case's time blocks are laid over so many steps of the whole",
        optional, positive},
       plan.block_steps);
  take(columns_option, plan.columns);
}

/// Run a mixing deck until the charge is steady: the words behind `mix`.
struct MixingOptions {
  std::filesystem::path deck;    ///< LIGGGHTS's input script, with one `run` of `plan.most` steps
  std::filesystem::path record;  ///< to be written: how it went (CSV)
  MixingPlan plan;
  std::optional<long> columns = {};  ///< of ranks along x, to be balanced
  bool operator==(const MixingOptions&) const = default;
};

template <class Take>
void for_each_option(MixingOptions& options, const Take& take) {
  using enum OptionNeed;
  using enum OptionRange;
  take({.name = "--in", .help = "LIGGGHTS's input script, with one `run`", .short_name = "-i"},
       options.deck);
  take({"--record", "file to write: how it went (CSV)"}, options.record);
  take({"--piece",
        "steps that torque and kinetic energy are averaged over, by the script's `fix drift all "
        "ave/time`; whole pitches",
        required, positive},
       options.plan.piece);
  take({"--after", "what comes up to this step is left out", required, not_negative},
       options.plan.left_out);
  take({"--at-most", "the last step it may reach; the script's `run`", required, positive},
       options.plan.most);
  take({"--revolution", "steps of one revolution", required, positive}, options.plan.revolution);
  take(columns_option, options.columns);
}

/// Run a deck and record nothing: the words behind `run`.
struct DeckRunOptions {
  std::filesystem::path deck;
  std::optional<long> columns = {};  ///< of ranks along x, to be balanced
  bool operator==(const DeckRunOptions&) const = default;
};

template <class Take>
void for_each_option(DeckRunOptions& options, const Take& take) {
  take(deck_option, options.deck);
  take(columns_option, options.columns);
}

/// The words of the recorder's command line, without the program. Parsed, they give the same order.
[[nodiscard]] std::vector<std::string> to_arguments(RecordingPlan plan);
[[nodiscard]] std::vector<std::string> to_arguments(MixingOptions options);
[[nodiscard]] std::vector<std::string> to_arguments(DeckRunOptions options);

}  // namespace millwear
