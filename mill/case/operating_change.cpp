#include "mill/case/operating_change.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mill/base/constants.h"

namespace millwear {
namespace {

constexpr double same_time = 1.0;     // [s]
constexpr double same_height = 2e-6;  // [m]

bool has_begun(const OperatingChange& change, const LinerMoment& moment) {
  if (change.from_time) return moment.time + same_time >= *change.from_time;
  return moment.height <= *change.from_height + same_height;
}

/// The changes that have begun by `hours`, in the order of their beginnings.
std::vector<std::size_t> in_time(std::span<const double> begun_hours, double hours) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < begun_hours.size(); ++i)
    if (begun_hours[i] <= hours) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return begun_hours[i]; });
  return order;
}

}  // namespace

std::vector<std::size_t> changes_begun(std::span<const OperatingChange> changes,
                                       const LinerMoment& moment) {
  std::vector<std::size_t> begun;
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (has_begun(changes[i], moment)) begun.push_back(i);
  return begun;
}

bool asks_for_load(const OperatingChange& change) {
  return change.speed || !change.counts.empty() || change.rotation;
}

std::vector<std::size_t> loads_asked_for(std::span<const OperatingChange> changes,
                                         std::span<const std::size_t> begun) {
  std::vector<std::size_t> asking;
  std::ranges::copy_if(begun, std::back_inserter(asking),
                       [&](std::size_t i) { return asks_for_load(changes[i]); });
  return asking;
}

LoadRange range_of_load(std::span<const OperatingChange> changes, const LinerMoment& moment) {
  LoadRange range;
  for (const OperatingChange& change : changes) {
    if (!asks_for_load(change) || has_begun(change, moment)) continue;
    if (change.from_time) range.time = std::min(range.time, *change.from_time - moment.time);
    if (change.from_height) range.height = std::max(range.height, *change.from_height);
  }
  return range;
}

double calendar_hours(std::span<const OperatingChange> changes, std::span<const double> begun_hours,
                      double hours) {
  double calendar = hours;
  for (const std::size_t i : in_time(begun_hours, hours))
    calendar += changes[i].idle_time / seconds_per_hour;
  return calendar;
}

double tonnes_milled(std::optional<double> first_rate, std::span<const OperatingChange> changes,
                     std::span<const double> begun_hours, double hours) {
  double tonnes = 0.0;
  double from = 0.0;
  auto rate = first_rate.value_or(std::nan(""));
  const auto mill_until = [&](double until) {
    if (until > from) tonnes += rate * (until - from) * seconds_per_hour / kilograms_per_tonne;
    from = until;
  };
  for (const std::size_t i : in_time(begun_hours, hours)) {
    mill_until(begun_hours[i]);
    rate = changes[i].feed_rate.value_or(rate);
  }
  mill_until(hours);
  return std::isnan(rate) ? rate : tonnes;
}

std::vector<double> begun_hours_after(std::span<const OperatingChange> changes,
                                      std::vector<double> begun_hours, const LinerMoment& step_end,
                                      double end_hours) {
  begun_hours.resize(changes.size(), std::nan(""));
  for (const std::size_t i : changes_begun(changes, step_end)) {
    if (!std::isnan(begun_hours[i])) continue;
    const auto& from = changes[i].from_time;
    begun_hours[i] = from ? std::min(*from / seconds_per_hour, end_hours) : end_hours;
  }
  return begun_hours;
}

}  // namespace millwear
