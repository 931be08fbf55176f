#include "wear/calibrate/course.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace millwear::wear {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double same_factor = 1e-9;

/// The moment at which the piece ends that holds `time`.
Eigen::Index piece_end(const Course& course, double time) {
  const auto after = std::lower_bound(course.times.begin() + 1, course.times.end() - 1, time);
  return after - course.times.begin();
}

/// H(f t) = start + slope f on a piece.
struct Line {
  double start;
  double slope;
};

Line line_at(const Course& course, double time, double factor) {
  const Eigen::Index end = piece_end(course, factor * time);
  const double pace =
      (course.values[end] - course.values[end - 1]) / (course.times[end] - course.times[end - 1]);
  return {course.values[end] - pace * course.times[end], pace * time};
}

/// chi^2(f) = square f^2 - 2 pull f + rest, between two factors at which no reading changes piece.
struct Parabola {
  double square = 0.0;
  double pull = 0.0;
  double rest = 0.0;
  [[nodiscard]] double at(double factor) const {
    return (square * factor - 2.0 * pull) * factor + rest;
  }
};

Parabola parabola_at(const Course& course, std::span<const DatedLength> readings, double factor) {
  Parabola sum;
  for (const DatedLength& reading : readings) {
    const Line line = line_at(course, reading.time, factor);
    const double weight = 1.0 / (reading.error * reading.error);
    const double off = reading.value - line.start;
    sum.square += weight * line.slope * line.slope;
    sum.pull += weight * line.slope * off;
    sum.rest += weight * off * off;
  }
  return sum;
}

/// Factors at which a reading passes a moment of the course, from 0 to the largest possible.
std::vector<double> breaks_of(const Course& course, std::span<const DatedLength> readings) {
  const double latest =
      std::ranges::max_element(readings, {}, [](const DatedLength& r) { return r.time; })->time;
  const double most = course.times.tail<1>()[0] / latest;
  std::vector<double> breaks{0.0, most};
  for (const DatedLength& reading : readings)
    for (const double time : course.times)
      if (time > 0.0 && time / reading.time < most) breaks.push_back(time / reading.time);
  std::ranges::sort(breaks);
  return breaks;
}

}  // namespace

double value_at(const Course& course, double time) {
  if (!(time >= course.times[0] && time <= course.times.tail<1>()[0])) return unknown;
  const Eigen::Index end = piece_end(course, time);
  const double share = (time - course.times[end - 1]) / (course.times[end] - course.times[end - 1]);
  return (1.0 - share) * course.values[end - 1] + share * course.values[end];
}

double time_of(const Course& course, double value) {
  const auto found = std::find_if(course.values.begin(), course.values.end(),
                                  [&](double v) { return v <= value; });
  if (found == course.values.end()) return unknown;
  const Eigen::Index end = found - course.values.begin();
  if (end == 0) return course.times[0];
  const double share =
      (course.values[end - 1] - value) / (course.values[end - 1] - course.values[end]);
  return course.times[end - 1] + share * (course.times[end] - course.times[end - 1]);
}

CourseFactor factor_of(const Course& course, std::span<const DatedLength> readings) {
  const auto breaks = breaks_of(course, readings);
  double best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  double next = 0.0;  // where the best piece's own parabola is least
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double low = breaks[i - 1];
    const double high = breaks[i];
    const Parabola sum = parabola_at(course, readings, 0.5 * (low + high));
    const double lowest = sum.square > 0.0 ? sum.pull / sum.square : low;
    const double factor = std::clamp(lowest, low, high);
    if (const double chi_square = sum.at(factor); chi_square < least) {
      least = chi_square;
      best = factor;
      next = lowest;
    }
  }
  if (!(best > 0.0)) return {0.0, FactorPlace::not_worn};
  const bool at_end = best >= breaks.back();
  return {best,
          at_end && next > best * (1.0 + same_factor) ? FactorPlace::beyond : FactorPlace::inside};
}

double straight_rate(double fresh, std::span<const DatedLength> readings) {
  double products = 0.0;
  double squares = 0.0;
  for (const DatedLength& reading : readings) {
    const double weight = 1.0 / (reading.error * reading.error);
    products += weight * reading.time * (fresh - reading.value);
    squares += weight * reading.time * reading.time;
  }
  return products / squares;
}

}  // namespace millwear::wear
