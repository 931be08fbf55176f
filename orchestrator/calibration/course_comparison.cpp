#include "orchestrator/calibration/course_comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "mill/base/constants.h"
#include "mill/base/csv.h"
#include "mill/base/number_or_null.h"
#include "orchestrator/calibration/course_verdict.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr CsvFormat format{
    "millwear calibrated comparison 1",
    "operating_hours,use,lifter_height_m_measured,error_m,lifter_height_m_predicted,"
    "lifter_height_m_low,lifter_height_m_high,lifter_height_m_line,plate_thickness_m_measured,"
    "plate_thickness_m_predicted,plate_thickness_m_low,plate_thickness_m_high"};

Json json_of(const Banded& banded) {
  return {{"value", number_or_null(banded.value)},
          {"low", number_or_null(banded.band.low)},
          {"high", number_or_null(banded.band.high)}};
}

/// Without the sign of what rounds to zero.
double rounded_mm(double metres) { return std::round(1e4 * metres) / 10.0 + 0.0; }

std::string cell(double metres) {
  return std::isfinite(metres) ? fmt::format("{:7.1f}", rounded_mm(metres))
                               : fmt::format("{:>7}", "-");
}

std::string band_cell(const wear::Band& band) {
  return fmt::format(
      "{:>14}", std::isfinite(band.low)
                    ? fmt::format("{:.1f} to {:.1f}", rounded_mm(band.low), rounded_mm(band.high))
                    : "-");
}

std::string spoken_band(const Banded& banded, int digits) {
  return std::isfinite(banded.band.low)
             ? fmt::format(" (95 % band {:.{}f} to {:.{}f})", banded.band.low, digits,
                           banded.band.high, digits)
             : "";
}

std::string row_text(const CourseReading& reading) {
  const double measured = reading.height.value_or(nan);
  return fmt::format("{:8.0f} {:6.0f}  {} {} {} {} {} {}  {} {} {}  {}\n", reading.operating_hours,
                     reading.operating_hours / hours_per_day, cell(measured),
                     cell(reading.predicted.value), band_cell(reading.predicted.band),
                     cell(reading.predicted.value - measured), cell(reading.line),
                     cell(reading.line - measured), cell(reading.plate.value_or(nan)),
                     cell(reading.predicted_plate.value), band_cell(reading.predicted_plate.band),
                     spoken(reading.use));
}

std::string life_text(const CalibratedCourse& course) {
  if (std::isnan(course.life.value)) return "";
  std::string text = fmt::format("Life to {:.1f} mm: {:.0f} h{}", 1e3 * course.height_limit,
                                 course.life.value, spoken_band(course.life, 0));
  if (std::isfinite(course.line_life))
    text += fmt::format("; by the straight line {:.0f} h", course.line_life);
  return text + ".\n";
}

}  // namespace

std::string course_text(const CalibratedCourse& course) {
  std::string text = fmt::format(
      "Calibrated on the heights read up to {:g} h, {}:\nevery coefficient of the wear law times "
      "{:.4g}{}, the campaign's hours divided by it.\n\n",
      course.until, spoken(course.gauge_on), course.factor.value, spoken_band(course.factor, 3));
  text += fmt::format("{:15}  {:<55}  {}\n", "", "height [mm]", "plate [mm]");
  text += fmt::format("{:>8} {:>6}  {:>7} {:>7} {:>14} {:>7} {:>7} {:>7}  {:>7} {:>7} {:>14}\n",
                      "hours", "days", "read", "pred", "95 % band", "diff", "line", "diff", "read",
                      "pred", "95 % band");
  for (const CourseReading& reading : course.readings) text += row_text(reading);
  text += "Differences are less the reading; the bands do not hold the reading's own error.\n\n";
  text += course.verdict + "\n" + life_text(course);
  for (const std::string& remark : course.remarks) text += fmt::format("Note: {}.\n", remark);
  return text;
}

std::string course_json(const CalibratedCourse& course) {
  Json readings = Json::array();
  for (const CourseReading& reading : course.readings)
    readings.push_back({{"operating_hours", reading.operating_hours},
                        {"use", spoken(reading.use)},
                        {"lifter_height_m", number_or_null(reading.height)},
                        {"error_m", reading.error},
                        {"predicted_height_m", json_of(reading.predicted)},
                        {"line_height_m", reading.line},
                        {"plate_thickness_m", number_or_null(reading.plate)},
                        {"predicted_plate_m", json_of(reading.predicted_plate)}});
  return Json{{"calibrated_until_hours", course.until},
              {"gauge_on", course.gauge_on == GaugeOn::plate ? "plate" : "new-plate"},
              {"factor", json_of(course.factor)},
              {"readings", readings},
              {"held_out", course.held_out},
              {"rms_height_m", number_or_null(course.rms)},
              {"line_rms_height_m", number_or_null(course.line_rms)},
              {"mape_height", number_or_null(course.mape)},
              {"line_mape_height", number_or_null(course.line_mape)},
              {"height_limit_m", course.height_limit},
              {"life_hours", json_of(course.life)},
              {"line_life_hours", number_or_null(course.line_life)},
              {"verdict", course.verdict},
              {"remarks", course.remarks}}
      .dump(1);
}

std::string course_csv(const CalibratedCourse& course) {
  std::string text = csv_head(format);
  for (const CourseReading& reading : course.readings)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   csv_number(reading.operating_hours), spoken(reading.use),
                   csv_number(reading.height.value_or(nan)), csv_number(reading.error),
                   csv_number(reading.predicted.value), csv_number(reading.predicted.band.low),
                   csv_number(reading.predicted.band.high), csv_number(reading.line),
                   csv_number(reading.plate.value_or(nan)),
                   csv_number(reading.predicted_plate.value),
                   csv_number(reading.predicted_plate.band.low),
                   csv_number(reading.predicted_plate.band.high));
  return text;
}

}  // namespace millwear::orchestrator
