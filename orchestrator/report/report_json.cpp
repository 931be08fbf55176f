#include "orchestrator/report/report_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "mill/base/number_or_null.h"
#include "orchestrator/report/charge_json.h"
#include "orchestrator/report/html_text.h"
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

/// What of a row stands in a column.
struct ColumnValue {
  const HistoryRow& row;
  Json operator()(int HistoryRow::*member) const { return row.*member; }
  Json operator()(double HistoryRow::*member) const { return row.*member; }
  Json operator()(InDegrees<HistoryRow> angle) const { return row.*angle.member; }
  Json operator()(const auto&) const { return nullptr; }
};

Json json_of(const HistoryRow& row) {
  Json json = Json::object();
  for (const auto& column : history_columns())
    json[std::string(column.field)] = std::visit(ColumnValue{row}, column.member);
  return json;
}

Json json_of(const MeasuredCharge& charge) {
  return {{"cycle", charge.cycle},       {"operating_hours", charge.operating_hours},
          {"power", charge.power},       {"power_error", charge.power_error},
          {"shoulder", charge.shoulder}, {"shoulder_error", charge.shoulder_error},
          {"toe", charge.toe},           {"toe_error", charge.toe_error}};
}

// The long arrays of a campaign are written as text at once: a document of them costs more than all
// the rest of a publication.
constexpr int shown_digits = 8;  // of numbers in an array

void write(std::string& text, double number, std::optional<int> most_digits = {}) {
  if (!std::isfinite(number)) {
    text += "null";
    return;
  }
  std::array<char, 32> digits;
  char* const end = digits.data() + digits.size();
  text.append(
      digits.data(),
      most_digits
          ? std::to_chars(digits.data(), end, number, std::chars_format::general, *most_digits).ptr
          : std::to_chars(digits.data(), end, number).ptr);
}

void write(std::string& text, int number) { text += std::to_string(number); }

void write(std::string& text, const Eigen::Vector2d& point) {
  text += '[';
  write(text, point.x(), shown_digits);
  text += ',';
  write(text, point.y(), shown_digits);
  text += ']';
}

void write(std::string& text, const LoadLine& line);
void write(std::string& text, const ProfileRow& row);
void write(std::string& text, const LoadAlongProfile& load);

template <class T>
void write(std::string& text, const std::vector<T>& items) {
  text += '[';
  for (const auto& item : items) {
    if constexpr (std::is_same_v<T, double>)
      write(text, item, shown_digits);
    else
      write(text, item);
    text += ',';
  }
  if (!items.empty()) text.pop_back();
  text += ']';
}

template <class T>
void write_member(std::string& text, std::string_view name, const T& value) {
  fmt::format_to(std::back_inserter(text), "{}\"{}\":", text.back() == '{' ? "" : ",", name);
  write(text, value);
}

void write(std::string& text, const ProfileRow& row) {
  text += '{';
  write_member(text, "cycle", row.cycle);
  write_member(text, "step", row.step);
  write_member(text, "operating_hours", row.operating_hours);
  write_member(text, "nodes", row.nodes);
  write_member(text, "depth_error", row.depth_error);
  text += '}';
}

void write(std::string& text, const LoadLine& line) {
  text += '{';
  write_member(text, "raw", line.raw);
  write_member(text, "standard_error", line.standard_error);
  write_member(text, "smoothed", line.smoothed);
  write_member(text, "smoothed_error", line.smoothed_error);
  text += '}';
}

void write(std::string& text, const LoadAlongProfile& load) {
  text += '{';
  write_member(text, "cycle", load.cycle);
  write_member(text, "arc_length", load.arc_length);
  write_member(text, "width", load.width);
  write_member(text, "centres", load.centres);
  write_member(text, "contacts", load.contacts);
  write_member(text, "normal_dissipation", load.normal_dissipation);
  write_member(text, "sliding_work", load.sliding_work);
  write_member(text, "depth_rate", load.depth_rate);
  text += '}';
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
          {"load_scatter", balance.load_scatter},
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

}  // namespace

std::string report_json(const CampaignResults& data, std::size_t most_frame_bytes) {
  const Json json = {{"case_name", data.case_name},
                     {"description", all(data.description)},
                     {"life", json_of(data.life)},
                     {"sector", json_of(data.sector)},
                     {"height_limit", data.height_limit},
                     {"plate_limit", data.plate_limit},
                     {"liner_density", data.liner_density},
                     {"history", all(data.history)},
                     {"charges", all(measured_charges(data.history))},
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
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  write_member(text, "profiles", data.profiles);
  write_member(text, "loads", data.loads);
  text += ",\"charge\":" + charge_json(data, most_frame_bytes);
  return inside_script(text + "}");
}

}  // namespace millwear::orchestrator
