#include "orchestrator/loads/load_along_profile.h"

#include "mill/liner/profile_measures.h"
#include "wear/numerics/block_means.h"
#include "wear/numerics/block_persistence.h"
#include "wear/rate/smoothing_error.h"
#include "wear/surface/along_profile.h"

namespace millwear::orchestrator {
namespace {

std::vector<double> as_vector(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// One measure of the load per surface of one lifter and per second, smoothed like the loss.
LoadLine rate_line(const WallLoad& load, Measure measure, const Eigen::ArrayXd& divisor,
                   const wear::Smoothing& how) {
  const Eigen::MatrixXd by_block = load.by_block(measure);
  const Eigen::VectorXd raw = load.total(measure).array() / divisor;
  const Eigen::MatrixXd block_rates = wear::as_independent(
      (by_block.array().colwise() / divisor).matrix() * static_cast<double>(load.block_count));
  const Eigen::VectorXd positive = raw.cwiseMax(0.0);
  LoadLine line{
      as_vector(raw), as_vector(wear::error_of_mean(block_rates)), as_vector(positive), {}};
  if (!(positive.sum() > 0.0)) return line;
  const auto smooth = wear::smoothed(load.bin_edges, positive, block_rates, how);
  line.smoothed = as_vector(smooth.rate.values);
  line.smoothed_error = as_vector(wear::standard_error(smooth));
  return line;
}

}  // namespace

LoadAlongProfile load_along_profile(int cycle, const wear::LoadRate& rate) {
  const auto& load = rate.load;
  const Eigen::VectorXd widths = load.bin_widths();
  const Eigen::ArrayXd surface_time =
      load.bin_area().array() * static_cast<double>(load.rows) * load.duration;
  return {cycle,
          as_vector(load.bin_edges.head(load.bins()) + 0.5 * widths),
          as_vector(widths),
          {},
          rate_line(load, Measure::samples, widths.array(), rate.how),
          rate_line(load, Measure::normal_dissipation, surface_time, rate.how),
          rate_line(load, Measure::sliding_work, surface_time, rate.how),
          {as_vector(rate.raw),
           {},
           as_vector(rate.smoothed.rate.values),
           as_vector(wear::standard_error(rate.smoothed))}};
}

std::vector<Eigen::Vector2d> bin_places(const LinerProfile& liner, Rotation rotation,
                                        const std::vector<double>& at) {
  const LinerProfile profile = as_turned(liner, rotation);
  const auto arc = arc_lengths(profile);
  std::vector<Eigen::Vector2d> places;
  for (const double s : at) places.push_back(as_turned(wear::place_at(profile, arc, s), rotation));
  return places;
}

}  // namespace millwear::orchestrator
