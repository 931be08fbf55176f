#include "orchestrator/calibration/course_calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/failure.h"
#include "orchestrator/calibration/course_replicates.h"
#include "orchestrator/calibration/course_verdict.h"
#include "wear/calibrate/course.h"
#include "wear/evolve/evolution.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CourseQuantities courses_of(const std::vector<HistoryRow>& history, GaugeOn gauge) {
  const auto course = [&](double HistoryRow::*value) {
    wear::Course made{Eigen::VectorXd(static_cast<Eigen::Index>(history.size())), {}};
    made.values.resizeLike(made.times);
    for (Eigen::Index i = 0; i < made.times.size(); ++i) {
      made.times[i] = history[static_cast<std::size_t>(i)].operating_hours;
      made.values[i] = history[static_cast<std::size_t>(i)].*value;
    }
    return made;
  };
  const auto height = course(&HistoryRow::lifter_height);
  const auto plate = course(&HistoryRow::plate_thickness);
  return {height, plate, as_read(height, plate, gauge)};
}

std::vector<wear::DatedLength> heights_until(const std::vector<GaugeReading>& readings,
                                             double until) {
  std::vector<wear::DatedLength> heights;
  for (const GaugeReading& reading : readings)
    if (reading.lifter_height && reading.operating_hours > 0.0 && reading.operating_hours <= until)
      heights.push_back({reading.operating_hours, *reading.lifter_height, reading.error});
  return heights;
}

std::vector<wear::DatedLength> needed_heights(const std::vector<GaugeReading>& readings,
                                              double until) {
  auto heights = heights_until(readings, until);
  if (!heights.empty()) return heights;
  const auto all = heights_until(readings, std::numeric_limits<double>::infinity());
  throw InputError(
      fmt::format("no lifter height was read after 0 h and up to {:g} h, so there is nothing to "
                  "calibrate on; {}",
                  until,
                  all.empty() ? "bring in heights with `millwear import`"
                              : fmt::format("the first is of {:g} h: calibrate until then or later",
                                            all.front().time)));
}

/// Throws where a height is one that the campaign never has as this gauge reads it.
void check_reached(const wear::Course& course, const std::vector<wear::DatedLength>& heights) {
  constexpr double errors_apart = 3.0;
  for (const wear::DatedLength& height : heights)
    if (course.values.minCoeff() - height.value > errors_apart * height.error)
      throw InputError(fmt::format(
          "the {:.1f} mm read at {:g} h are deeper than any liner of the campaign as this gauge "
          "reads it ({:.1f} mm at least), and nothing is extrapolated; calibrate until an earlier "
          "reading, let `millwear run` wear the liner further, or look at --gauge-on",
          1e3 * height.value, height.time, 1e3 * course.values.minCoeff()));
}

void check_fit(const wear::CourseFactor& fit, const CourseQuantities& courses, double until) {
  if (fit.place == wear::FactorPlace::not_worn)
    throw InputError(
        fmt::format("the heights read up to {:g} h show no wear of the {:.1f} mm of the new "
                    "lifter, so there is "
                    "nothing to calibrate on; calibrate until a later reading",
                    until, 1e3 * courses.gauge.values[0]));
  if (fit.place == wear::FactorPlace::beyond)
    throw InputError(fmt::format(
        "the heights read up to {:g} h are deeper than the campaign's last liner (lifter {:.1f} mm "
        "high), and nothing is extrapolated; calibrate until an earlier reading, or let `millwear "
        "run` wear the liner further",
        until, 1e3 * courses.gauge.values.tail<1>()[0]));
}

/// The limit, or the last height where the campaign ended as near above it as campaigns do.
double limit_met(const wear::Course& heights, double limit) {
  const double last = heights.values.tail<1>()[0];
  return last <= limit + wear::limit_within ? std::max(limit, last) : limit;
}

CourseUse use_of(double hours, double until) {
  if (hours <= 0.0) return CourseUse::fresh;
  return hours <= until ? CourseUse::calibrated : CourseUse::held_out;
}

/// Root mean squares and mean percentages over the held-out heights that are predicted.
void sum_up(CalibratedCourse& course) {
  double squares = 0.0;
  double line_squares = 0.0;
  double shares = 0.0;
  double line_shares = 0.0;
  for (const CourseReading& reading : course.readings) {
    if (!reading.height || reading.use != CourseUse::held_out) continue;
    if (std::isnan(reading.predicted.value)) continue;
    ++course.held_out;
    squares += std::pow(reading.predicted.value - *reading.height, 2);
    line_squares += std::pow(reading.line - *reading.height, 2);
    shares += std::abs(reading.predicted.value / *reading.height - 1.0);
    line_shares += std::abs(reading.line / *reading.height - 1.0);
  }
  course.rms = course.held_out > 0 ? std::sqrt(squares / course.held_out) : nan;
  course.line_rms = course.held_out > 0 ? std::sqrt(line_squares / course.held_out) : nan;
  course.mape = course.held_out > 0 ? shares / course.held_out : nan;
  course.line_mape = course.held_out > 0 ? line_shares / course.held_out : nan;
}

}  // namespace

CalibratedCourse calibrated_course(const Case& mill, const CampaignCourse& campaign,
                                   const std::vector<GaugeReading>& readings,
                                   const CourseCalibration& how) {
  if (campaign.history.size() < 2)
    throw InputError("the campaign has no geometry step yet; let `millwear run` go on until then");
  const CourseQuantities courses = courses_of(campaign.history, how.gauge_on);
  const auto heights = needed_heights(readings, how.until);
  const wear::CourseFactor fit = wear::factor_of(courses.gauge, heights);
  check_reached(courses.gauge, heights);
  check_fit(fit, courses, how.until);
  const CalibratedReplicates replicates = calibrated_replicates(campaign, heights, how.gauge_on);

  CalibratedCourse course{};
  course.until = how.until;
  course.gauge_on = how.gauge_on;
  course.factor = {fit.factor, factor_band(replicates)};
  course.fresh_height = courses.gauge.values[0];
  course.line_rate = wear::straight_rate(course.fresh_height, heights);
  const auto banded = [&](const wear::Course& own, auto quantity, double hours) {
    const double value = wear::value_at(own, fit.factor * hours);
    return std::isnan(value) ? Banded{} : Banded{value, band_at(replicates, quantity, hours)};
  };
  for (const GaugeReading& reading : readings) {
    const double hours = reading.operating_hours;
    course.readings.push_back(
        {hours, use_of(hours, how.until), reading.lifter_height, reading.error,
         banded(courses.gauge, &CourseQuantities::gauge, hours),
         course.fresh_height - course.line_rate * hours, reading.plate_thickness,
         banded(courses.plate, &CourseQuantities::plate, hours)});
    course.beyond += std::isnan(course.readings.back().predicted.value) ? 1 : 0;
  }
  for (const double own_hours : courses.gauge.times) {
    const double hours = own_hours / fit.factor;
    const auto band = band_at(replicates, &CourseQuantities::gauge, hours);
    course.curve.push_back({hours, {wear::value_at(courses.gauge, own_hours), band}});
  }
  course.height_limit = mill.campaign.height_limit;
  course.life.value =
      wear::time_of(courses.height, limit_met(courses.height, course.height_limit)) / fit.factor;
  if (std::isfinite(course.life.value))
    course.life.band = life_band(replicates, course.height_limit);
  course.line_life = how.gauge_on == GaugeOn::new_plate
                         ? (course.fresh_height - course.height_limit) / course.line_rate
                         : nan;
  sum_up(course);
  course.verdict = verdict_of(course);
  course.remarks = remarks_of(course, mill, !campaign.replicates.empty());
  return course;
}

void add_calibrated_course(const Case& mill, const std::vector<GaugeReading>& readings,
                           CampaignResults& data) {
  if (!mill.gauge.calibrate_until || readings.empty() || data.history.size() < 2) return;
  try {
    data.calibrated = calibrated_course(mill, {data.history, data.replicates}, readings,
                                        {*mill.gauge.calibrate_until});
  } catch (const InputError& problem) {
    data.warnings.push_back(
        fmt::format("the calibrated prediction is left out: {}", problem.what()));
  }
}

}  // namespace millwear::orchestrator
