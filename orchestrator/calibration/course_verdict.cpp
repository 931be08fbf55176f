#include "orchestrator/calibration/course_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace millwear::orchestrator {
namespace {

/// Below this the two are called equal [m].
constexpr double same_height = 5e-5;

/// Whether a change of operation that asks for another load comes at given hours.
bool changes_by_hours(const CampaignSettings& plan) {
  return std::ranges::any_of(plan.operation, [](const OperatingChange& change) {
    return change.from_time && *change.from_time > 0.0 && asks_for_load(change);
  });
}

/// How well straight lines predicted liner readings of many plants.
struct PlantLines {
  int readings;
  int mills;
  double mape;
  std::string_view doi;
};
constexpr PlantLines plant_lines{143, 10, 0.055, "10.3390/min14121200"};

/// Root mean square of the errors of the readings that `verdict_of` is about [m].
double error_of_held_out(const CalibratedCourse& course) {
  double squares = 0.0;
  for (const CourseReading& reading : course.readings)
    if (reading.height && reading.use == CourseUse::held_out &&
        !std::isnan(reading.predicted.value))
      squares += reading.error * reading.error;
  return std::sqrt(squares / course.held_out);
}

std::string spoken_readings(int count) {
  return count == 1 ? "1 held-out reading" : fmt::format("{} held-out readings", count);
}

std::string comparison_of(const CalibratedCourse& course) {
  const double better = course.line_rms - course.rms;
  const std::string figures =
      fmt::format("{}: prediction off by {:.1f} mm (rms), straight line by {:.1f} mm",
                  spoken_readings(course.held_out), 1e3 * course.rms, 1e3 * course.line_rms);
  if (std::abs(better) < same_height) return figures + ". Neither is better.";
  const double worse = std::fmax(course.rms, course.line_rms);
  const double error = error_of_held_out(course);
  return fmt::format(
      "{}. The {} is better by {:.1f} mm ({:.0f} %){}.", figures,
      better > 0.0 ? "prediction" : "straight line", 1e3 * std::abs(better),
      100.0 * std::abs(better) / worse,
      std::abs(better) < error
          ? fmt::format(", less than the readings' own error of {:.1f} mm", 1e3 * error)
          : "");
}

}  // namespace

std::string verdict_of(const CalibratedCourse& course) {
  if (course.held_out == 0)
    return "No height is held out and predicted, so there is nothing to judge by.";
  return comparison_of(course) + " " + percentages_of(course.mape, course.line_mape);
}

std::string percentages_of(double prediction, double line) {
  return fmt::format(
      "Mean absolute percentage error: prediction {:.1f} %, straight line {:.1f} %. Straight lines "
      "through {} plant readings of {} mills: {:g} % (doi {}).",
      100.0 * prediction, 100.0 * line, plant_lines.readings, plant_lines.mills,
      100.0 * plant_lines.mape, plant_lines.doi);
}

std::vector<std::string> remarks_of(const CalibratedCourse& course, const Case& mill,
                                    bool has_replicates) {
  std::vector<std::string> remarks;
  if (course.beyond > 0)
    remarks.push_back(fmt::format(
        "{} after the campaign's last liner, which comes at {:.0f} h so calibrated (height {:.1f} "
        "mm); nothing is extrapolated, so there is no prediction",
        course.beyond == 1 ? "1 reading is" : fmt::format("{} readings are", course.beyond),
        course.curve.back().operating_hours, 1e3 * course.curve.back().height.value));
  if (!has_replicates)
    remarks.push_back(
        "there are no bands, because the folder has no replicates.csv; `millwear report` writes it "
        "where the campaign's loads are kept");
  if (std::isnan(course.life.value))
    remarks.push_back(fmt::format("the campaign does not reach the limit of {:.1f} mm",
                                  1e3 * course.height_limit));
  if (const auto& plan = mill.campaign; !plan.reversal_times.empty() || changes_by_hours(plan))
    remarks.push_back(
        "the operation changes at given hours, and these are divided by the factor, too: run the "
        "case with its coefficients times the factor");
  return remarks;
}

std::string spoken(GaugeOn gauge) {
  return gauge == GaugeOn::plate ? "from the worn plate" : "from the new plate";
}

}  // namespace millwear::orchestrator
