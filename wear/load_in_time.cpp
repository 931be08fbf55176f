#include "wear/load_in_time.h"

#include <algorithm>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

const TimedLoad& newest_of(std::span<const TimedLoad> loads) {
  if (loads.empty()) throw InputError("a liner wears under a load; there is none");
  return loads.back();
}

Eigen::VectorXd variance_of(const TimedLoad& load) {
  if (load.error.size() == 0) return Eigen::VectorXd::Zero(load.rate.values.size());
  return load.error.cwiseAbs2();
}

}  // namespace

std::span<const TimedLoad> in_use(std::span<const TimedLoad> loads, Scheme scheme) {
  return scheme == Scheme::threshold && loads.size() > 1 ? loads.last(1) : loads;
}

LoadInTime::LoadInTime(std::span<const TimedLoad> loads)
    : newest_(newest_of(loads)), carrier_(newest_.profile, newest_.rate.values.size()) {
  if (loads.size() < 2) return;
  previous_ = loads[loads.size() - 2];
  if (!(previous_->time < newest_.time)) {
    throw InputError("the loads on a wearing liner have to be in the order of their times");
  }
  previous_onto_newest_ = LoadCarrier(previous_->profile, previous_->rate.values.size())
                              .onto_bins(newest_.profile, newest_.rate.values.size());
  const Eigen::VectorXd before = previous_onto_newest_ * previous_->rate.values;
  const double difference = (newest_.rate.values - before).squaredNorm();
  const double noise =
      (variance_of(newest_) + previous_onto_newest_ * variance_of(*previous_)).sum();
  believed_ = difference > 0.0 ? std::max(0.0, 1.0 - noise / difference) : 0.0;
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

Eigen::VectorXd LoadInTime::rate(double time) const {
  if (!previous_) return newest_.rate.values;
  return sum(time, newest_.rate.values, previous_->rate.values).cwiseMax(0.0);
}

LoadInTime::Prediction LoadInTime::predicted(const LinerProfile& worn, double time) const {
  const double share = share_of_previous(time);
  Eigen::VectorXd variance = (1.0 - share) * (1.0 - share) * variance_of(newest_);
  Eigen::VectorXd rate = newest_.rate.values;
  if (previous_) {
    rate = sum(time, rate, previous_->rate.values);
    variance += share * share * (previous_onto_newest_ * variance_of(*previous_));
  }
  const auto rows = carrier_.onto_bins(worn, rate.size());
  return {rows * rate, rows * variance};
}

}  // namespace millwear::wear
