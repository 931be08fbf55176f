#include "orchestrator/tuning_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "orchestrator/versioned_json.h"

namespace millwear::orchestrator {
namespace {

constexpr int tuning_version = 1;
using nlohmann::json;

json json_of(const Tuning& tuning, const SkinTrial& trial) {
  const bool is_timed = !trial.loop_seconds.empty();
  return {{"skin_m", trial.skin},
          {"loop_seconds", trial.loop_seconds},
          {"steps_per_second", is_timed ? json(steps_per_second(tuning, trial)) : json(nullptr)},
          {"neighbour_builds", trial.neighbour_builds},
          {"dangerous_builds", trial.dangerous_builds},
          {"refused", trial.refused.empty() ? json(nullptr) : json(trial.refused)}};
}

SkinTrial trial_from(const json& trial) {
  const auto& refused = trial.at("refused");
  return {trial.at("skin_m").get<double>(), trial.at("loop_seconds").get<std::vector<double>>(),
          trial.at("neighbour_builds").get<long>(), trial.at("dangerous_builds").get<long>(),
          refused.is_null() ? "" : refused.get<std::string>()};
}

std::string table_row(const Tuning& tuning, const SkinTrial& trial) {
  const double millimetres = 1e3 * trial.skin;
  if (!trial.refused.empty())
    return fmt::format("{:9.3f}  refused: {}\n", millimetres, trial.refused);
  const auto [least, most] = std::ranges::minmax(trial.loop_seconds);
  const auto steps = static_cast<double>(tuning.piece_steps);
  return fmt::format("{:9.3f}  {:9.1f}  {:9.1f}  {:9.1f}  {:9.1f}{}\n", millimetres,
                     steps_per_second(tuning, trial), steps / most, steps / least,
                     steps / static_cast<double>(std::max(1L, trial.neighbour_builds)),
                     trial.skin == tuning.skin ? "  <" : "");
}

}  // namespace

std::string tuning_json(const Tuning& tuning) {
  json trials = json::array();
  for (const auto& trial : tuning.trials) trials.push_back(json_of(tuning, trial));
  const auto& chosen = chosen_trial(tuning);
  const json document = {{"type", "millwear tuning"},
                         {"format_version", tuning_version},
                         {"particles", tuning.particles},
                         {"ranks", tuning.ranks},
                         {"time_step_s", tuning.time_step},
                         {"piece_steps", tuning.piece_steps},
                         {"trials", trials},
                         {"skin_m", tuning.skin},
                         {"steps_per_second", steps_per_second(tuning, chosen)},
                         {"simulated_seconds_per_hour", simulated_seconds_per_hour(tuning, chosen)},
                         {"dem_line", dem_line(tuning)}};
  return document.dump(1) + "\n";
}

Tuning read_tuning(const std::filesystem::path& file) {
  return read_versioned_json(file, "millwear tuning", tuning_version, [](const json& document) {
    Tuning tuning{document.at("particles").get<std::size_t>(),
                  document.at("ranks").get<int>(),
                  document.at("time_step_s").get<double>(),
                  document.at("piece_steps").get<long>(),
                  {},
                  document.at("skin_m").get<double>()};
    for (const auto& trial : document.at("trials")) tuning.trials.push_back(trial_from(trial));
    if (std::ranges::find(tuning.trials, tuning.skin, &SkinTrial::skin) == tuning.trials.end())
      throw ResultRejected(fmt::format("its chosen skin of {} m was not tried", tuning.skin));
    return tuning;
  });
}

std::string tuning_text(const Tuning& tuning) {
  std::string text = fmt::format(
      "{} particles, {} rank{}, pieces of {} steps in turns\n"
      "     skin    steps/s                        steps per\n"
      "       mm     median      least       most    rebuild\n",
      tuning.particles, tuning.ranks, tuning.ranks == 1 ? "" : "s", tuning.piece_steps);
  for (const auto& trial : tuning.trials) text += table_row(tuning, trial);
  const auto& chosen = chosen_trial(tuning);
  return text + fmt::format(
                    "{:.4g} mm: {} steps a second, {:.4g} s of the mill in an hour. For the "
                    "case:\n[dem]\n{}\n",
                    1e3 * tuning.skin, spoken_speed(tuning, chosen),
                    simulated_seconds_per_hour(tuning, chosen), dem_line(tuning));
}

std::string spoken_speed(const Tuning& tuning, const SkinTrial& trial) {
  const double speed = steps_per_second(tuning, trial);
  return speed < 100.0 ? fmt::format("{:.3g}", speed) : fmt::format("{:.0f}", speed);
}

std::string dem_line(const Tuning& tuning) { return fmt::format("skin_m = {}", tuning.skin); }

}  // namespace millwear::orchestrator
