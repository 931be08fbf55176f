#include "orchestrator/dem_run/tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/case/time_step.h"

namespace millwear::orchestrator {
namespace {

constexpr double least_in_radii = 0.15;
constexpr double most_in_radii = 2.0;
constexpr int rungs = 7;
constexpr double same_skin_share = 0.05;
constexpr double tie_share = 0.02;
constexpr double builds_a_piece = 4.0;
constexpr long least_piece_steps = 100;

double to_three_digits(double value) { return std::stod(fmt::format("{:.3g}", value)); }

}  // namespace

std::vector<RankSplit> splits_on_trial(const Case& mill, int ranks) {
  if (ranks % 2 == 1) return {};
  const RankSplit own = liggghts::rank_split(mill, ranks);
  return {own, own == RankSplit::charge ? RankSplit::axis : RankSplit::charge};
}

std::vector<double> skins_on_trial(const Case& mill) {
  const double own = liggghts::neighbour_skin(mill);
  const double radius = 0.5 * smallest_diameter(mill);
  std::vector<double> skins = {own};
  for (int i = 0; i < rungs; ++i) {
    const double share = static_cast<double>(i) / (rungs - 1);
    const double skin =
        to_three_digits(radius * least_in_radii * std::pow(most_in_radii / least_in_radii, share));
    if (std::abs(skin - own) > same_skin_share * own) skins.push_back(skin);
  }
  std::ranges::sort(skins);
  return skins;
}

liggghts::TrialSteps trial_steps(const Case& mill, const std::vector<double>& skins) {
  const double liner_step =
      mill.speed * mill.liner.sector.plate_radius * plan_steps(mill).time_step;
  const double between_builds = 0.5 * skins.back() / liner_step;
  const long timed =
      std::max(least_piece_steps, static_cast<long>(std::ceil(builds_a_piece * between_builds)));
  return {.warm_up = timed / 4, .timed = timed};
}

double median_seconds(const DeckTrial& trial) {
  std::vector<double> seconds = trial.loop_seconds;
  if (seconds.empty()) return std::nan("");
  std::ranges::sort(seconds);
  const std::size_t middle = seconds.size() / 2;
  return seconds.size() % 2 == 1 ? seconds[middle] : 0.5 * (seconds[middle - 1] + seconds[middle]);
}

void add_piece(DeckTrial& trial, double loop_seconds, long neighbour_builds,
               long dangerous_builds) {
  trial.loop_seconds.push_back(loop_seconds);
  trial.neighbour_builds = neighbour_builds;
  trial.dangerous_builds = std::max(trial.dangerous_builds, dangerous_builds);
  if (trial.dangerous_builds > 0)
    trial.refused = "a particle or the liner crosses half of it in one step";
}

std::optional<DeckSettings> fastest_settings(const std::vector<DeckTrial>& trials) {
  double best = INFINITY;
  for (const auto& trial : trials)
    if (trial.refused.empty()) best = std::min(best, median_seconds(trial));
  for (const auto& trial : trials)
    if (trial.refused.empty() && median_seconds(trial) <= (1.0 + tie_share) * best)
      return trial.settings;
  return std::nullopt;
}

DeckSettings chosen_settings(const std::vector<DeckTrial>& skin_trials) {
  if (const auto fastest = fastest_settings(skin_trials)) return *fastest;
  const DeckTrial& widest = skin_trials.back();
  throw ResultRejected(
      fmt::format("no skin can be taken, each was refused (the widest, {:g} m: {}); give `skin_m` "
                  "in [dem]",
                  widest.settings.skin, widest.refused));
}

const DeckTrial& chosen_trial(const Tuning& tuning) {
  return *std::ranges::find(tuning.skin_trials, tuning.chosen, &DeckTrial::settings);
}

double steps_per_second(const Tuning& tuning, const DeckTrial& trial) {
  return static_cast<double>(tuning.piece_steps) / median_seconds(trial);
}

double simulated_seconds_per_hour(const Tuning& tuning, const DeckTrial& trial) {
  return seconds_per_hour * tuning.time_step * steps_per_second(tuning, trial);
}

}  // namespace millwear::orchestrator
