#pragma once
#include <string>
#include <vector>

#include "liggghts_inputs/deck.h"
#include "mill/case.h"

namespace millwear::orchestrator {

/// A neighbour skin on trial, and how it did in equal pieces from the same charge.
struct SkinTrial {
  double skin;                         ///< [m]
  std::vector<double> loop_seconds{};  ///< of each timed piece [s]
  long neighbour_builds = 0;           ///< in one piece
  long dangerous_builds = 0;           ///< in any
  std::string refused{};               ///< why it may not be taken; empty if it may
};

/// What a trial of speed found.
struct Tuning {
  std::size_t particles;
  int ranks;
  double time_step;  ///< [s]
  long piece_steps;  ///< timed, of each piece
  std::vector<SkinTrial> trials;
  double skin;  ///< the chosen one [m]
};

/// The skins on trial [m], increasing: the one that the case's decks have without a trial, and a
/// geometric ladder from 0.15 to 2 of the least particle radius, to three digits. A ladder's skin
/// within 5 % of the first is left out.
[[nodiscard]] std::vector<double> skins_on_trial(const Case& mill);

/// The steps of one piece: long enough for the widest skin to be rebuilt some times, on account of
/// the liner's motion alone.
[[nodiscard]] liggghts::TrialSteps trial_steps(const Case& mill, const std::vector<double>& skins);

/// The median of the pieces [s]; of an even number the mean of the middle two.
[[nodiscard]] double median_seconds(const SkinTrial& trial);

/// Adds a piece that was timed. One with dangerous builds refuses the skin: contacts may have been
/// missed.
void add_piece(SkinTrial& trial, double loop_seconds, long neighbour_builds, long dangerous_builds);

/// The fastest skin by the median of its pieces [m]. Those within 2 % of it count as equally fast,
/// and of these the smallest is taken: it needs the least memory. Throws ResultRejected, saying
/// why, where every skin was refused.
[[nodiscard]] double chosen_skin(const std::vector<SkinTrial>& trials);

/// The trial of the chosen skin.
[[nodiscard]] const SkinTrial& chosen_trial(const Tuning& tuning);

[[nodiscard]] double steps_per_second(const Tuning& tuning, const SkinTrial& trial);
/// Simulated time in an hour of wall time [s].
[[nodiscard]] double simulated_seconds_per_hour(const Tuning& tuning, const SkinTrial& trial);

}  // namespace millwear::orchestrator
