#include "orchestrator/dem_run/tuning_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/versioned_json.h"

namespace millwear::orchestrator {
namespace {

constexpr int tuning_version = 2;
using nlohmann::json;

json json_of(const Tuning& tuning, const DeckTrial& trial) {
  const bool is_timed = !trial.loop_seconds.empty();
  return {{"rank_split", name_of(trial.settings.rank_split)},
          {"skin_m", trial.settings.skin},
          {"loop_seconds", trial.loop_seconds},
          {"steps_per_second", is_timed ? json(steps_per_second(tuning, trial)) : json(nullptr)},
          {"neighbour_builds", trial.neighbour_builds},
          {"dangerous_builds", trial.dangerous_builds},
          {"refused", trial.refused.empty() ? json(nullptr) : json(trial.refused)}};
}

json json_of(const Tuning& tuning, const std::vector<DeckTrial>& trials) {
  json list = json::array();
  for (const auto& trial : trials) list.push_back(json_of(tuning, trial));
  return list;
}

DeckSettings settings_from(const json& object) {
  const auto split = object.at("rank_split").get<std::string>();
  for (const RankSplit known : {RankSplit::charge, RankSplit::axis, RankSplit::balanced})
    if (split == name_of(known)) return {known, object.at("skin_m").get<double>()};
  throw ResultRejected(fmt::format("it has an unknown rank_split `{}`", split));
}

DeckTrial trial_from(const json& trial) {
  const auto& refused = trial.at("refused");
  return {settings_from(trial), trial.at("loop_seconds").get<std::vector<double>>(),
          trial.at("neighbour_builds").get<long>(), trial.at("dangerous_builds").get<long>(),
          refused.is_null() ? "" : refused.get<std::string>()};
}

std::vector<DeckTrial> trials_from(const json& list) {
  std::vector<DeckTrial> trials;
  for (const auto& trial : list) trials.push_back(trial_from(trial));
  return trials;
}

std::string table_row(const Tuning& tuning, const DeckTrial& trial) {
  const auto begin =
      fmt::format("{:>7}  {:9.3f}", name_of(trial.settings.rank_split), 1e3 * trial.settings.skin);
  if (!trial.refused.empty()) return fmt::format("{}  refused: {}", begin, trial.refused);
  const auto [least, most] = std::ranges::minmax(trial.loop_seconds);
  const auto steps = static_cast<double>(tuning.piece_steps);
  return fmt::format("{}  {:9.1f}  {:9.1f}  {:9.1f}  {:9.1f}", begin,
                     steps_per_second(tuning, trial), steps / most, steps / least,
                     steps / static_cast<double>(std::max(1L, trial.neighbour_builds)));
}

}  // namespace

std::string tuning_json(const Tuning& tuning) {
  const auto& chosen = chosen_trial(tuning);
  const json document = {{"type", "millwear tuning"},
                         {"format_version", tuning_version},
                         {"particles", tuning.particles},
                         {"ranks", tuning.ranks},
                         {"time_step_s", tuning.time_step},
                         {"piece_steps", tuning.piece_steps},
                         {"split_trials", json_of(tuning, tuning.split_trials)},
                         {"skin_trials", json_of(tuning, tuning.skin_trials)},
                         {"rank_split", name_of(tuning.chosen.rank_split)},
                         {"skin_m", tuning.chosen.skin},
                         {"steps_per_second", steps_per_second(tuning, chosen)},
                         {"simulated_seconds_per_hour", simulated_seconds_per_hour(tuning, chosen)},
                         {"dem_lines", dem_lines(tuning)}};
  return document.dump(1) + "\n";
}

Tuning read_tuning(const std::filesystem::path& file) {
  return read_versioned_json(file, "millwear tuning", tuning_version, [](const json& document) {
    Tuning tuning{document.at("particles").get<std::size_t>(),
                  document.at("ranks").get<int>(),
                  document.at("time_step_s").get<double>(),
                  document.at("piece_steps").get<long>(),
                  trials_from(document.at("split_trials")),
                  trials_from(document.at("skin_trials")),
                  settings_from(document)};
    if (std::ranges::find(tuning.skin_trials, tuning.chosen, &DeckTrial::settings) ==
        tuning.skin_trials.end())
      throw ResultRejected(
          fmt::format("its chosen skin of {} m was not tried with the ranks split by {}",
                      tuning.chosen.skin, name_of(tuning.chosen.rank_split)));
    return tuning;
  });
}

std::string tuning_text(const Tuning& tuning) {
  std::string text = fmt::format(
      "{} particles, {} rank{}, pieces of {} steps in turns\n"
      "  ranks       skin    steps/s                        steps per\n"
      "  split         mm     median      least       most    rebuild\n",
      tuning.particles, tuning.ranks, tuning.ranks == 1 ? "" : "s", tuning.piece_steps);
  for (const auto& trial : tuning.split_trials) text += table_row(tuning, trial) + "\n";
  if (!tuning.split_trials.empty()) text += "\n";
  const auto& chosen = chosen_trial(tuning);
  for (const auto& trial : tuning.skin_trials)
    text += table_row(tuning, trial) + (&trial == &chosen ? "  <\n" : "\n");
  return text +
         fmt::format(
             "{} steps a second, {:.4g} s of the mill in an hour. For the case:\n[dem]\n{}\n",
             spoken_speed(tuning, chosen), simulated_seconds_per_hour(tuning, chosen),
             dem_lines(tuning));
}

std::string spoken_speed(const Tuning& tuning, const DeckTrial& trial) {
  const double speed = steps_per_second(tuning, trial);
  return speed < 100.0 ? fmt::format("{:.3g}", speed) : fmt::format("{:.0f}", speed);
}

std::string dem_lines(const Tuning& tuning) {
  std::string lines = fmt::format("skin_m = {}", tuning.chosen.skin);
  if (!tuning.split_trials.empty())
    lines += fmt::format("\nrank_split = \"{}\"", name_of(tuning.chosen.rank_split));
  return lines;
}

}  // namespace millwear::orchestrator
