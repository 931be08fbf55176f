#include "orchestrator/calibration/repeated_courses.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "orchestrator/campaign/case_difference.h"
#include "wear/band/life_band.h"
#include "wear/band/repeats.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The value that `of` takes from every course.
template <class Of>
Repeated repeated(const std::vector<CalibratedCourse>& courses, Of of) {
  std::vector<double> values;
  std::vector<double> errors;
  for (const CalibratedCourse& course : courses) {
    const Banded& banded = of(course);
    values.push_back(banded.value);
    errors.push_back(wear::standard_error_of(banded.band));
  }
  const auto [mean, scatter, predicted_error] = wear::repeats_of(values, errors);
  return {std::move(values), mean, scatter, predicted_error};
}

/// Root mean square of what `off` gives for the held-out heights that all campaigns predict.
template <class Off>
double rms(const RepeatedCourses& repeats, Off off) {
  double squares = 0.0;
  for (const RepeatedReading& reading : repeats.readings)
    if (is_judged(reading)) squares += std::pow(off(reading) - *reading.height, 2);
  return repeats.held_out > 0 ? std::sqrt(squares / repeats.held_out) : nan;
}

/// Mean of the relative errors of what `off` gives for the same heights.
template <class Off>
double mape(const RepeatedCourses& repeats, Off off) {
  double shares = 0.0;
  for (const RepeatedReading& reading : repeats.readings)
    if (is_judged(reading)) shares += std::abs(off(reading) / *reading.height - 1.0);
  return repeats.held_out > 0 ? shares / repeats.held_out : nan;
}

Case as_if_seed_one(Case mill) {
  mill.name.clear();
  mill.dem.seed = 1;
  return mill;
}

}  // namespace

bool is_judged(const RepeatedReading& reading) {
  return reading.use == CourseUse::held_out && reading.height &&
         std::isfinite(reading.predicted.mean);
}

void check_repeats(const std::vector<Case>& cases,
                   const std::vector<std::filesystem::path>& folders) {
  for (std::size_t i = 1; i < cases.size(); ++i) {
    auto texts = differences(as_if_seed_one(cases[i]), as_if_seed_one(cases[0]));
    if (!texts.empty())
      throw InputError(fmt::format(
          "{}: its campaign is no repeat of the one in {}: besides the seed it differs in {}; name "
          "campaigns of one case, or compare them one by one",
          folders[i].string(), folders[0].string(), fmt::join(texts, ", ")));
    for (std::size_t k = 0; k < i; ++k)
      if (cases[k].dem.seed == cases[i].dem.seed)
        throw InputError(fmt::format(
            "{} and {}: both campaigns have seed {}, so they are one and the same; name campaigns "
            "with different seeds",
            folders[k].string(), folders[i].string(), cases[i].dem.seed));
  }
}

RepeatedCourses repeated_courses(std::vector<CalibratedCourse> courses,
                                 std::vector<std::uint64_t> seeds) {
  expect(courses.size() > 1 && seeds.size() == courses.size(),
         "repeats are two courses or more, each with its seed");
  const auto& first = courses.front();
  RepeatedCourses made{{}, std::move(seeds), {}, {}, {}, 0, nan, nan, nan, nan};
  made.factor = repeated(courses, [](const auto& course) { return course.factor; });
  made.life = repeated(courses, [](const auto& course) { return course.life; });
  for (std::size_t i = 0; i < first.readings.size(); ++i) {
    const CourseReading& reading = first.readings[i];
    made.readings.push_back(
        {reading.operating_hours, reading.use, reading.height,
         repeated(courses, [i](const auto& course) { return course.readings.at(i).predicted; }),
         repeated(courses,
                  [i](const auto& course) { return course.readings.at(i).predicted_plate; }),
         reading.line});
  }
  made.held_out = static_cast<int>(std::ranges::count_if(made.readings, is_judged));
  made.rms = rms(made, [](const RepeatedReading& reading) { return reading.predicted.mean; });
  made.line_rms = rms(made, [](const RepeatedReading& reading) { return reading.line; });
  made.mape = mape(made, [](const RepeatedReading& reading) { return reading.predicted.mean; });
  made.line_mape = mape(made, [](const RepeatedReading& reading) { return reading.line; });
  made.courses = std::move(courses);
  return made;
}

}  // namespace millwear::orchestrator
