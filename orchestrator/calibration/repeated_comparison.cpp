#include "orchestrator/calibration/repeated_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
    "millwear repeated comparison 1",
    "operating_hours,use,lifter_height_m_measured,lifter_height_m_mean,lifter_height_m_scatter,"
    "lifter_height_m_se,lifter_height_m_line,plate_thickness_m_mean,plate_thickness_m_scatter,"
    "plate_thickness_m_se"};

std::string cell(double metres) {
  return std::isfinite(metres) ? fmt::format("{:7.1f}", 1e3 * metres) : fmt::format("{:>7}", "-");
}

std::string cells(const Repeated& repeated) {
  return fmt::format("{} {} {}", cell(repeated.mean), cell(repeated.scatter),
                     cell(repeated.predicted_error));
}

std::string row_text(const RepeatedReading& reading) {
  const double measured = reading.height.value_or(nan);
  std::string each;
  for (const double value : reading.predicted.values) each += " " + cell(value);
  return fmt::format("{:8.0f} {:6.0f}  {}{} {}  {} {} {}  {}  {}\n", reading.operating_hours,
                     reading.operating_hours / hours_per_day, cell(measured), each,
                     cells(reading.predicted), cell(reading.predicted.mean - measured),
                     cell(reading.line), cell(reading.line - measured),
                     cells(reading.predicted_plate), spoken(reading.use));
}

std::string numbers(const std::vector<double>& values, std::string_view number) {
  std::vector<std::string> texts;
  for (const double value : values)
    texts.push_back(std::isfinite(value) ? fmt::format(fmt::runtime(number), value) : "-");
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string verdict(const RepeatedCourses& repeats) {
  if (repeats.held_out == 0)
    return "No held-out height is predicted by every campaign, so there is nothing to judge by.\n";
  std::vector<double> each;
  for (const CalibratedCourse& course : repeats.courses) each.push_back(1e3 * course.rms);
  return fmt::format(
      "{} held-out reading{}: the mean is off by {:.1f} mm (rms), each campaign by {} mm, the "
      "straight line by {:.1f} mm.\n{}\n",
      repeats.held_out, repeats.held_out == 1 ? "" : "s", 1e3 * repeats.rms,
      numbers(each, "{:.1f}"), 1e3 * repeats.line_rms,
      percentages_of(repeats.mape, repeats.line_mape));
}

Json json_of(const Repeated& repeated) {
  Json values = Json::array();
  for (const double value : repeated.values) values.push_back(Json(number_or_null(value)));
  return {{"values", values},
          {"mean", number_or_null(repeated.mean)},
          {"scatter", number_or_null(repeated.scatter)},
          {"predicted_error", number_or_null(repeated.predicted_error)}};
}

}  // namespace

std::string repeated_text(const RepeatedCourses& repeats) {
  const auto& first = repeats.courses.front();
  std::string text = fmt::format(
      "{} campaigns, seeds {}, each calibrated on the heights read up to {:g} h, {}:\nevery "
      "coefficient of the wear law times {}.\n\n",
      repeats.courses.size(), fmt::join(repeats.seeds, ", "), first.until, spoken(first.gauge_on),
      numbers(repeats.factor.values, "{:.4g}"));
  std::string seeds;
  for (const auto seed : repeats.seeds)
    seeds += fmt::format(" {:>7}", fmt::format("seed {}", seed));
  const std::string three = fmt::format("{:>7} {:>7} {:>7}", "mean", "scatter", "pred se");
  text +=
      fmt::format("{:15}  {:<{}}  {}\n", "", "height [mm]", 7 + seeds.size() + 50, "plate [mm]");
  text += fmt::format("{:>8} {:>6}  {:>7}{} {}  {:>7} {:>7} {:>7}  {}\n", "hours", "days", "read",
                      seeds, three, "diff", "line", "diff", three);
  for (const RepeatedReading& reading : repeats.readings) text += row_text(reading);
  text +=
      "Scatter is the standard deviation between the campaigns, pred se the standard error that "
      "each predicts.\n\n";
  text += verdict(repeats);
  if (std::isfinite(repeats.life.mean))
    text += fmt::format(
        "Life to {:.1f} mm: {} h; mean {:.0f} h, scatter {:.0f} h, predicted {:.0f} h.\n",
        1e3 * first.height_limit, numbers(repeats.life.values, "{:.0f}"), repeats.life.mean,
        repeats.life.scatter, repeats.life.predicted_error);
  return text;
}

std::string repeated_json(const RepeatedCourses& repeats) {
  Json readings = Json::array();
  for (const RepeatedReading& reading : repeats.readings)
    readings.push_back({{"operating_hours", reading.operating_hours},
                        {"use", spoken(reading.use)},
                        {"lifter_height_m", number_or_null(reading.height)},
                        {"predicted_height_m", json_of(reading.predicted)},
                        {"line_height_m", reading.line},
                        {"predicted_plate_m", json_of(reading.predicted_plate)}});
  Json rms = Json::array();
  for (const CalibratedCourse& course : repeats.courses)
    rms.push_back(Json(number_or_null(course.rms)));
  const auto& first = repeats.courses.front();
  return Json{{"seeds", repeats.seeds},
              {"calibrated_until_hours", first.until},
              {"gauge_on", first.gauge_on == GaugeOn::plate ? "plate" : "new-plate"},
              {"factor", json_of(repeats.factor)},
              {"readings", readings},
              {"held_out", repeats.held_out},
              {"rms_height_m", number_or_null(repeats.rms)},
              {"rms_height_m_each", rms},
              {"line_rms_height_m", number_or_null(repeats.line_rms)},
              {"mape_height", number_or_null(repeats.mape)},
              {"line_mape_height", number_or_null(repeats.line_mape)},
              {"height_limit_m", first.height_limit},
              {"life_hours", json_of(repeats.life)}}
      .dump(1);
}

std::string repeated_csv(const RepeatedCourses& repeats) {
  std::string text = csv_head(format);
  for (const RepeatedReading& reading : repeats.readings)
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\n",
                   csv_number(reading.operating_hours), spoken(reading.use),
                   csv_number(reading.height.value_or(nan)), csv_number(reading.predicted.mean),
                   csv_number(reading.predicted.scatter),
                   csv_number(reading.predicted.predicted_error), csv_number(reading.line),
                   csv_number(reading.predicted_plate.mean),
                   csv_number(reading.predicted_plate.scatter),
                   csv_number(reading.predicted_plate.predicted_error));
  return text;
}

}  // namespace millwear::orchestrator
