#include "mill/load/drift_text.h"

#include <fmt/format.h>

#include "mill/base/line_parts.h"

namespace millwear {
namespace {

constexpr std::string_view too_early = "too early to tell a drift";
constexpr std::string_view torque = "torque drifts by ";
constexpr std::string_view energy = ", kinetic energy by ";
constexpr std::string_view particle_class = ", class ";
constexpr std::string_view on_liner = " on the liner by ";
constexpr std::string_view per_cent = " %";
constexpr std::string_view limit = " (limit ";
constexpr std::string_view limit_end = " %)";

std::string spoken(double share) { return fmt::format("{:.2g}", 100.0 * share); }

std::string spoken(const Drift& drift) {
  return fmt::format("{}{}{}{}{}", spoken(drift.relative), per_cent, limit, spoken(drift.limit),
                     limit_end);
}

void read(LineParts& parts, Drift& drift) {
  parts.percent(drift.relative).text(per_cent).text(limit).percent(drift.limit).text(limit_end);
}

}  // namespace

std::string spoken_drift(const std::optional<MixingDrift>& drift) {
  if (!drift) return std::string(too_early);
  std::string text =
      fmt::format("{}{}{}{}", torque, spoken(drift->torque), energy, spoken(drift->kinetic_energy));
  if (const auto& worst = drift->on_liner)
    text += fmt::format("{}{}{}{}", particle_class, worst->particle_class + 1, on_liner,
                        spoken(worst->share));
  return text;
}

std::string spoken_torque_drift(const std::optional<MixingDrift>& drift) {
  if (!drift) return std::string(too_early);
  return fmt::format("{}{}{}", torque, spoken(drift->torque.relative), per_cent);
}

bool read_drift(std::string_view text, std::optional<MixingDrift>& drift) {
  drift.reset();
  if (text == too_early) return true;
  MixingDrift found{};
  LineParts parts(text);
  read(parts.text(torque), found.torque);
  read(parts.text(energy), found.kinetic_energy);
  if (!parts.left().empty()) {
    std::size_t number = 0;
    parts.text(particle_class).number(number).text(on_liner);
    read(parts, found.on_liner.emplace(ClassDrift{number - 1, {}}).share);
  }
  if (parts.fits_to_the_end()) drift = found;
  return parts.fits_to_the_end();
}

}  // namespace millwear
