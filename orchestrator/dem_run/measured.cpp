#include "orchestrator/dem_run/measured.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "mill/base/number_or_null.h"
#include "mill/base/versioned_json.h"
#include "mill/base/whole_file.h"
#include "wear/record/measurement_goal.h"

namespace millwear::orchestrator {
namespace {

constexpr int measured_version = 3;
using nlohmann::json;

double number_from(const json& value) {
  return value.is_null() ? std::nan("") : value.get<double>();
}

std::optional<double> optional_from(const json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

json json_of(const wear::Estimate& estimate) {
  return {{"value", number_or_null(estimate.value)}, {"se", number_or_null(estimate.error)}};
}
wear::Estimate estimate_from(const json& value) {
  return {number_from(value.at("value")), number_from(value.at("se"))};
}

json json_of(const wear::MotionMeasures& motion, double mill_power) {
  const auto& hits = motion.bare_hit_power;
  return {{"airborne_share", json_of(motion.airborne_share)},
          {"dead_zone_share", json_of(motion.dead_zone_share)},
          {"between_lifters_locked_share", json_of(motion.between_locked_share)},
          {"packed_share", json_of(motion.packed_share)},
          {"bare_hit_mass_share_per_revolution", json_of(motion.bare_hit_mass_share)},
          {"bare_hit_power_w", json_of(motion.bare_hit_power)},
          {"bare_hit_power_share", json_of({hits.value / mill_power, hits.error / mill_power})},
          {"bare_hit_falling_side_power_w", json_of(motion.bare_hit_falling_power)},
          {"bare_hit_plate_power_w", json_of(motion.bare_hit_plate_power)}};
}
wear::MotionMeasures motion_from(const json& document) {
  const auto estimate = [&](const char* key) { return estimate_from(document.at(key)); };
  return {.airborne_share = estimate("airborne_share"),
          .dead_zone_share = estimate("dead_zone_share"),
          .between_locked_share = estimate("between_lifters_locked_share"),
          .packed_share = estimate("packed_share"),
          .bare_hit_mass_share = estimate("bare_hit_mass_share_per_revolution"),
          .bare_hit_power = estimate("bare_hit_power_w"),
          .bare_hit_falling_power = estimate("bare_hit_falling_side_power_w"),
          .bare_hit_plate_power = estimate("bare_hit_plate_power_w")};
}

/// What a target that was missed would take.
std::string spoken_need(const Measured& measured) {
  const double target = *measured.target_error;
  const double need = wear::length_to_reach({target, measured.peak_error}, measured.revolutions);
  return std::isfinite(need)
             ? fmt::format("{:g} % would take about {:.0f}", 100.0 * target, std::ceil(need - 0.1))
             : fmt::format("target {:g} %", 100.0 * target);
}

}  // namespace

MeasurementEnd end_of(const Measured& measured) {
  if (!measured.target_error) return MeasurementEnd::no_target;
  return wear::is_reached({*measured.target_error, measured.peak_error})
             ? MeasurementEnd::target_reached
             : MeasurementEnd::most_revolutions;
}

std::string_view name_of(MeasurementEnd end) {
  switch (end) {
    case MeasurementEnd::no_target:
      return "no target";
    case MeasurementEnd::target_reached:
      return "target reached";
    case MeasurementEnd::most_revolutions:
      return "greatest number of revolutions";
  }
  throw std::logic_error("an end of no kind");
}

std::string spoken_end(const Measured& measured) {
  const std::string turns = fmt::format("{:.4g}", measured.revolutions);
  std::string text = fmt::format("measured for {} revolution{}, ", turns, turns == "1" ? "" : "s");
  text += std::isfinite(measured.peak_error)
              ? fmt::format("rate at its peaks known to {:.2g} %", 100.0 * measured.peak_error)
              : "rate at its peaks not known";
  const double target = 100.0 * measured.target_error.value_or(0.0);
  switch (end_of(measured)) {
    case MeasurementEnd::no_target:
      return text;
    case MeasurementEnd::target_reached:
      return fmt::format("{} (target {:g} %)", text, target);
    case MeasurementEnd::most_revolutions:
      return fmt::format("{} after the greatest number of revolutions; {}", text,
                         spoken_need(measured));
  }
  throw std::logic_error("an end of no kind");
}

void write_measured(const std::filesystem::path& file, const Measured& measured) {
  const json document = {{"type", "millwear measured"},
                         {"format_version", measured_version},
                         {"power_w", measured.power},
                         {"power_w_se", number_or_null(measured.power_error)},
                         {"power_times_s", measured.power_times},
                         {"power_series_w", measured.power_series},
                         {"toe_rad", number_or_null(measured.charge.toe)},
                         {"toe_rad_se", number_or_null(measured.charge.toe_error)},
                         {"shoulder_rad", number_or_null(measured.charge.shoulder)},
                         {"shoulder_rad_se", number_or_null(measured.charge.shoulder_error)},
                         {"motion", json_of(measured.motion, measured.power)},
                         {"samples", measured.samples},
                         {"rejected_share", measured.rejected_share},
                         {"revolutions", measured.revolutions},
                         {"peak_relative_error", number_or_null(measured.peak_error)},
                         {"target_relative_error", number_or_null(measured.target_error)},
                         {"ended", name_of(end_of(measured))}};
  write_file(file, document.dump(1) + "\n");
}

Measured read_measured(const std::filesystem::path& file) {
  return read_versioned_json(file, "millwear measured", measured_version, [](const json& document) {
    return Measured{
        document.at("power_w").get<double>(),
        number_from(document.at("power_w_se")),
        document.at("power_times_s").get<std::vector<double>>(),
        document.at("power_series_w").get<std::vector<double>>(),
        {number_from(document.at("toe_rad")), number_from(document.at("toe_rad_se")),
         number_from(document.at("shoulder_rad")), number_from(document.at("shoulder_rad_se"))},
        document.at("samples").get<long>(),
        document.at("rejected_share").get<double>(),
        document.at("revolutions").get<double>(),
        number_from(document.at("peak_relative_error")),
        optional_from(document.at("target_relative_error")),
        motion_from(document.at("motion"))};
  });
}

}  // namespace millwear::orchestrator
