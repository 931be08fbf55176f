#pragma once
#include <optional>
#include <string>
#include <vector>

#include "liggghts_inputs/decks/deck.h"
#include "mill/case/case.h"

namespace millwear::orchestrator {

/// What of a deck costs time and is no physics: how the ranks share the mill, and the neighbour
/// skin.
struct DeckSettings {
  RankSplit rank_split;
  double skin;  ///< [m]
  bool operator==(const DeckSettings&) const = default;
};

/// Settings on trial, and how they did in equal pieces from the same charge.
struct DeckTrial {
  DeckSettings settings;
  std::vector<double> loop_seconds{};  ///< of each timed piece [s]
  long neighbour_builds = 0;           ///< in one piece
  long dangerous_builds = 0;           ///< in any
  std::string refused{};               ///< why it may not be taken; empty if it may
};

/// What a trial of speed found.
struct Tuning {
  std::size_t particles;
  int ranks;
  double time_step;                     ///< [s]
  long piece_steps;                     ///< timed, of each piece
  std::vector<DeckTrial> split_trials;  ///< all with one skin; none where there is one split only
  std::vector<DeckTrial> skin_trials;   ///< all with the fastest split
  DeckSettings chosen;                  ///< by these
};

/// The splits on trial, the one of the case's decks first; none for an odd number of ranks, which
/// have no choice.
[[nodiscard]] std::vector<RankSplit> splits_on_trial(const Case& mill, int ranks);

/// The skins on trial [m], increasing: the one that the case's decks have without a trial, and a
/// geometric ladder from 0.15 to 2 of the least particle radius, to three digits. A ladder's skin
/// within 5 % of the first is left out.
[[nodiscard]] std::vector<double> skins_on_trial(const Case& mill);

/// The steps of one piece: long enough for the widest skin to be rebuilt some times, on account of
/// the liner's motion alone.
[[nodiscard]] liggghts::TrialSteps trial_steps(const Case& mill, const std::vector<double>& skins);

/// The median of the pieces [s]; of an even number the mean of the middle two.
[[nodiscard]] double median_seconds(const DeckTrial& trial);

/// Adds a piece that was timed. One with dangerous builds refuses its skin: contacts may have been
/// missed.
void add_piece(DeckTrial& trial, double loop_seconds, long neighbour_builds, long dangerous_builds);

/// The fastest settings by the median of their pieces; std::nullopt where all were refused. Those
/// within 2 % of them count as equally fast, and of these the first are taken.
[[nodiscard]] std::optional<DeckSettings> fastest_settings(const std::vector<DeckTrial>& trials);

/// The settings with the fastest of increasing skins, or of those equally fast the smallest, which
/// takes the least memory. Throws ResultRejected, saying why, where every skin was refused.
[[nodiscard]] DeckSettings chosen_settings(const std::vector<DeckTrial>& skin_trials);

/// The trial of the chosen settings, among those of skins.
[[nodiscard]] const DeckTrial& chosen_trial(const Tuning& tuning);

[[nodiscard]] double steps_per_second(const Tuning& tuning, const DeckTrial& trial);
/// Simulated time in an hour of wall time [s].
[[nodiscard]] double simulated_seconds_per_hour(const Tuning& tuning, const DeckTrial& trial);

}  // namespace millwear::orchestrator
