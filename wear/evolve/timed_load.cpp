#include "wear/evolve/timed_load.h"

#include <algorithm>

#include "wear/evolve/load_carrier.h"
#include "wear/numerics/block_means.h"
#include "wear/record/profile_index.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index zones = 12;

/// The zone of `liner` that each bin of the load lies in.
std::vector<Eigen::Index> zones_of_bins(const TimedLoad& load, const LinerProfile& liner) {
  const auto lengths = arc_lengths(load.profile);
  const double width = load.rate.bin_width();
  const ProfileIndex index(liner, 4.0 * width, grid_for_hundreds);
  std::vector<Eigen::Index> found;
  for (Eigen::Index bin = 0; bin < load.rate.values.size(); ++bin) {
    const auto centre = place_at(load.profile, lengths, (static_cast<double>(bin) + 0.5) * width);
    const double share = index.nearest(centre).arc_length / index.length();
    found.push_back(std::min(static_cast<Eigen::Index>(share * zones), zones - 1));
  }
  return found;
}

}  // namespace

const Eigen::VectorXd& per_path(const TimedLoad& load) {
  return load.rolling ? load.rolling->per_path : load.rate.values;
}

double section_rate(const TimedLoad& load) {
  return load.rate.values.sum() * load.rate.bin_width();
}

ZonedLoad zoned(const TimedLoad& load, const LinerProfile& liner) {
  const bool is_exact = load.by_block.cols() < 2;
  const Eigen::MatrixXd by_block = is_exact ? Eigen::MatrixXd(load.rate.values) : load.by_block;
  const auto zone_of_bin = zones_of_bins(load, liner);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(zones, by_block.cols());
  for (Eigen::Index bin = 0; bin < by_block.rows(); ++bin) {
    sums.row(zone_of_bin[static_cast<std::size_t>(bin)]) +=
        load.rate.bin_width() * by_block.row(bin);
  }
  if (is_exact) return {sums.col(0), Eigen::VectorXd::Zero(zones)};
  return {sums.rowwise().mean(), error_of_mean(sums).cwiseAbs2()};
}

}  // namespace millwear::wear
