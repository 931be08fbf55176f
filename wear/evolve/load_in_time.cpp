#include "wear/evolve/load_in_time.h"

#include <algorithm>

#include "mill/base/contract.h"

namespace millwear::wear {
namespace {

constexpr double clearly = 2.0;

const TimedLoad& newest_of(std::span<const TimedLoad> loads) {
  expect(!loads.empty(), "a liner wears under one load or more");
  return loads.back();
}

Rolling rolling_of(const TimedLoad& load) {
  if (load.rolling) return *load.rolling;
  return {Eigen::VectorXd::Ones(load.rate.values.size()), load.rate.values, {0.0, 0.0}, 0.0};
}

}  // namespace

std::span<const TimedLoad> in_use(std::span<const TimedLoad> loads, Scheme scheme) {
  return scheme == Scheme::threshold && loads.size() > 1 ? loads.last(1) : loads;
}

LoadInTime::LoadInTime(std::span<const TimedLoad> loads)
    : newest_(newest_of(loads)),
      newest_rolling_(rolling_of(newest_)),
      carrier_(newest_.profile, newest_.rate.values.size()) {
  if (loads.size() < 2) return;
  previous_ = loads[loads.size() - 2];
  previous_per_path_ = wear::per_path(*previous_);
  expect(previous_->time < newest_.time, "the times of a liner's loads increase");
  previous_onto_newest_ = LoadCarrier(previous_->profile, previous_->rate.values.size())
                              .onto_bins(newest_.profile, newest_.rate.values.size());
  const ZonedLoad after = zoned(newest_, newest_.profile);
  const ZonedLoad before = zoned(*previous_, newest_.profile);
  const double difference = (after.rate - before.rate).squaredNorm();
  const double noise = (after.variance + before.variance).sum();
  believed_ = difference > 0.0 ? std::max(0.0, 1.0 - clearly * noise / difference) : 0.0;
}

double LoadInTime::share_of_previous(double time) const {
  if (!previous_) return 0.0;
  return -believed_ * (time - newest_.time) / (newest_.time - previous_->time);
}

Eigen::MatrixXd LoadInTime::sum(double time, const Eigen::MatrixXd& newest,
                                const Eigen::MatrixXd& previous) const {
  const double share = share_of_previous(time);
  if (share == 0.0) return newest;
  return (1.0 - share) * newest + share * (previous_onto_newest_ * previous);
}

Eigen::VectorXd LoadInTime::per_path(double time) const {
  if (!previous_) return newest_rolling_.per_path;
  return sum(time, newest_rolling_.per_path, previous_per_path_).cwiseMax(0.0);
}

double LoadInTime::section_rate(double time) const {
  const auto bins = static_cast<double>(newest_rolling_.path.size());
  return carrier_.bin_width() *
         (newest_rolling_.path.dot(per_path(time)) + bins * newest_rolling_.corrosion);
}

ZonedLoad LoadInTime::predicted(const LinerProfile& worn, double time) const {
  const double share = share_of_previous(time);
  ZonedLoad load = zoned(newest_, worn);
  if (share == 0.0) return load;
  const ZonedLoad before = zoned(*previous_, worn);
  return {(1.0 - share) * load.rate + share * before.rate,
          (1.0 - share) * (1.0 - share) * load.variance + share * share * before.variance};
}

}  // namespace millwear::wear
