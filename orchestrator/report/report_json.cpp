#include "orchestrator/report/report_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "mill/base/number_or_null.h"
#include "orchestrator/results/measured_charge.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class Convert>
Json array_of(const std::vector<T>& items, Convert convert) {
  Json array = Json::array();
  for (const auto& item : items) array.push_back(convert(item));
  return array;
}

Json json_of(const std::vector<Eigen::Vector2d>& points) {
  return array_of(points, [](const auto& p) { return Json::array({p.x(), p.y()}); });
}

Json json_of(const LabelledValue& line) { return Json::array({line.label, line.value}); }

Json json_of(const Life& life) {
  return {{"reached", life.reached},       {"hours", life.hours},   {"hours_low", life.hours_low},
          {"hours_high", life.hours_high}, {"tonnes", life.tonnes}, {"limit", life.limit}};
}

Json json_of(const HistoryRow& row) {
  return {{"cycle", row.cycle},
          {"step", row.step},
          {"operating_hours", row.operating_hours},
          {"tonnes", row.tonnes},
          {"lifter_height", row.lifter_height},
          {"face_angle", row.face_angle},
          {"plate_thickness", row.plate_thickness},
          {"worn_volume", row.worn_volume},
          {"worn_fraction", row.worn_fraction},
          {"power", row.power},
          {"power_error", row.power_error},
          {"shoulder", row.shoulder},
          {"shoulder_error", row.shoulder_error},
          {"toe", row.toe},
          {"toe_error", row.toe_error},
          {"lifter_height_error", row.lifter_height_error},
          {"plate_thickness_error", row.plate_thickness_error},
          {"worn_volume_error", row.worn_volume_error},
          {"airborne_share", row.airborne_share},
          {"airborne_share_error", row.airborne_share_error},
          {"bare_hit_power", row.bare_hit_power},
          {"bare_hit_power_error", row.bare_hit_power_error},
          {"dead_zone_share", row.dead_zone_share},
          {"dead_zone_share_error", row.dead_zone_share_error},
          {"between_locked_share", row.between_locked_share},
          {"between_locked_share_error", row.between_locked_share_error}};
}

Json json_of(const MeasuredCharge& charge) {
  return {{"cycle", charge.cycle},       {"operating_hours", charge.operating_hours},
          {"power", charge.power},       {"power_error", charge.power_error},
          {"shoulder", charge.shoulder}, {"shoulder_error", charge.shoulder_error},
          {"toe", charge.toe},           {"toe_error", charge.toe_error}};
}

Json json_of(const ProfileRow& row) {
  return {{"cycle", row.cycle},
          {"step", row.step},
          {"operating_hours", row.operating_hours},
          {"nodes", json_of(row.nodes)},
          {"depth_error", row.depth_error}};
}

Json json_of(const LoadLine& line) {
  return {{"raw", line.raw},
          {"standard_error", line.standard_error},
          {"smoothed", line.smoothed},
          {"smoothed_error", line.smoothed_error}};
}

Json json_of(const LoadAlongProfile& load) {
  return {{"cycle", load.cycle},
          {"arc_length", load.arc_length},
          {"width", load.width},
          {"centres", json_of(load.centres)},
          {"contacts", json_of(load.contacts)},
          {"normal_dissipation", json_of(load.normal_dissipation)},
          {"sliding_work", json_of(load.sliding_work)},
          {"depth_rate", json_of(load.depth_rate)}};
}

/// From the first class that is not empty to the last, with four digits.
Json json_of_rates(const std::vector<double>& rates) {
  const auto some = [](double rate) { return rate != 0.0; };
  const auto first = std::find_if(rates.begin(), rates.end(), some);
  const auto last = std::find_if(rates.rbegin(), rates.rend(), some).base();
  Json shown = Json::array();
  for (auto rate = first; rate < last; ++rate)
    shown.push_back(std::stod(fmt::format("{:.4g}", *rate)));
  return {{"first", first - rates.begin()}, {"rates", shown}};
}

Json json_of(const ImpactLine& line) {
  return {{"name", line.name},
          {"normal", json_of_rates(line.normal)},
          {"shear", json_of_rates(line.shear)},
          {"events_per_second", line.events_per_second},
          {"normal_power", line.normal_power},
          {"shear_power", line.shear_power},
          {"unfinished_share", line.unfinished_share},
          {"impact_speed", line.impact_speed}};
}

Json json_of(const Impacts& impacts) {
  const auto line = [](const ImpactLine& one) { return json_of(one); };
  return {{"cycle", impacts.cycle},
          {"liner", array_of(impacts.liner, line)},
          {"particles", array_of(impacts.particles, line)}};
}

Json json_of(const PowerSeries& series) {
  return {{"cycle", series.cycle}, {"time", series.time}, {"power", series.power}};
}

Json json_of(const wear::Estimate& estimate) {
  return {{"value", estimate.value}, {"error", estimate.error}};
}

Json json_of(const MotionOfCycle& motion) {
  const auto& measures = motion.measures;
  return {{"cycle", motion.cycle},
          {"airborne_share", json_of(measures.airborne_share)},
          {"dead_zone_share", json_of(measures.dead_zone_share)},
          {"between_locked_share", json_of(measures.between_locked_share)},
          {"packed_share", json_of(measures.packed_share)},
          {"bare_hit_mass_share", json_of(measures.bare_hit_mass_share)},
          {"bare_hit_power", json_of(measures.bare_hit_power)},
          {"bare_hit_falling_power", json_of(measures.bare_hit_falling_power)},
          {"bare_hit_plate_power", json_of(measures.bare_hit_plate_power)},
          {"hit_power", motion.hit_power}};
}

Json json_of(const Conservation& balance) {
  return {{"cycle", balance.cycle},
          {"removed", balance.removed},
          {"accounted", balance.accounted},
          {"moved_by_smoothing", balance.moved_by_smoothing},
          {"rejected", balance.rejected},
          {"revolutions", balance.revolutions},
          {"peak_error", balance.peak_error},
          {"path_over_slip", balance.path_over_slip},
          {"end", balance.end}};
}

Json json_of(const MeasuredHeight& measured) {
  return {{"operating_hours", measured.operating_hours},
          {"height", measured.height},
          {"error", measured.error}};
}

Json json_of(const Banded& banded) {
  return {{"value", banded.value}, {"low", banded.band.low}, {"high", banded.band.high}};
}

Json json_of(const CourseReading& reading) {
  return {{"operating_hours", reading.operating_hours},
          {"use", spoken(reading.use)},
          {"height", number_or_null(reading.height)},
          {"error", reading.error},
          {"predicted", json_of(reading.predicted)},
          {"line", reading.line},
          {"plate", number_or_null(reading.plate)},
          {"predicted_plate", json_of(reading.predicted_plate)}};
}

Json json_of(const CourseMoment& moment) {
  return {{"operating_hours", moment.operating_hours}, {"height", json_of(moment.height)}};
}

Json json_of(const std::optional<CalibratedCourse>& course) {
  if (!course) return nullptr;
  const auto each = [](const auto& item) { return json_of(item); };
  return {{"until", course->until},
          {"factor", json_of(course->factor)},
          {"readings", array_of(course->readings, each)},
          {"curve", array_of(course->curve, each)},
          {"fresh_height", course->fresh_height},
          {"line_rate", course->line_rate},
          {"height_limit", course->height_limit},
          {"life", json_of(course->life)},
          {"verdict", course->verdict},
          {"remarks", course->remarks}};
}

Json json_of(const MeasuredProfile& measured) {
  return {{"operating_hours", measured.operating_hours}, {"nodes", json_of(measured.nodes)}};
}

Json json_of(const LinerSector& sector) {
  return {{"shell_radius", sector.shell_radius},
          {"plate_radius", sector.plate_radius},
          {"rows", sector.rows}};
}

template <class T>
Json all(const std::vector<T>& items) {
  return array_of(items, [](const T& item) { return json_of(item); });
}

std::string inside_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string report_json(const CampaignResults& data) {
  const Json json = {{"case_name", data.case_name},
                     {"description", all(data.description)},
                     {"life", json_of(data.life)},
                     {"sector", json_of(data.sector)},
                     {"height_limit", data.height_limit},
                     {"plate_limit", data.plate_limit},
                     {"history", all(data.history)},
                     {"charges", all(measured_charges(data.history))},
                     {"profiles", all(data.profiles)},
                     {"loads", all(data.loads)},
                     {"energy_edges", data.energy_edges},
                     {"impacts", all(data.impacts)},
                     {"power", all(data.power)},
                     {"motion", all(data.motion)},
                     {"conservation", all(data.conservation)},
                     {"measured", all(data.measured)},
                     {"measured_profiles", all(data.measured_profiles)},
                     {"calibrated", json_of(data.calibrated)},
                     {"warnings", data.warnings},
                     {"provenance", all(data.provenance)}};
  return inside_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace millwear::orchestrator
