#include "wear/band/liner_replicates.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mill/liner/profile_measures.h"
#include "mill/liner/rotation.h"
#include "wear/numerics/block_means.h"

namespace millwear::wear {
namespace {

double bin_width(const LinerReplicates& liners) {
  return arc_lengths(liners.profile).back() / static_cast<double>(liners.deeper.rows());
}

/// The centre of a bin and the inward normal of the profile over that bin.
struct SurfacePlace {
  Eigen::Vector2d position;
  Eigen::Vector2d inward;
};

std::vector<SurfacePlace> surface_of(const LinerReplicates& liners) {
  const auto lengths = arc_lengths(liners.profile);
  const double width = bin_width(liners);
  std::vector<SurfacePlace> places;
  for (Eigen::Index bin = 0; bin < liners.deeper.rows(); ++bin) {
    const double left = static_cast<double>(bin) * width;
    const Eigen::Vector2d along = place_at(liners.profile, lengths, left + 0.99 * width) -
                                  place_at(liners.profile, lengths, left + 0.01 * width);
    places.push_back({place_at(liners.profile, lengths, left + 0.5 * width),
                      Eigen::Vector2d(along.y(), -along.x()).normalized()});
  }
  return places;
}

/// Least and greatest radius of a replicate less those of the predicted liner at the same places.
struct RadiusChange {
  double least;
  double greatest;
};

RadiusChange radius_change(const LinerReplicates& liners, const std::vector<SurfacePlace>& places,
                           Eigen::Index replicate) {
  const LinerSector& sector = liners.profile.sector;
  double least = sector.shell_radius * 2.0;
  double greatest = 0.0;
  double least_before = least;
  double greatest_before = greatest;
  for (Eigen::Index bin = 0; bin < liners.deeper.rows(); ++bin) {
    const SurfacePlace& place = places[static_cast<std::size_t>(bin)];
    const double before = radius_of(sector, place.position);
    const double after =
        radius_of(sector, place.position + liners.deeper(bin, replicate) * place.inward);
    least_before = std::min(least_before, before);
    greatest_before = std::max(greatest_before, before);
    least = std::min(least, after);
    greatest = std::max(greatest, after);
  }
  return {least - least_before, greatest - greatest_before};
}

/// Square of the relative standard error of a load's section rate.
double relative_variance(const TimedLoad& load) {
  if (load.by_block.cols() < 2) return 0.0;
  const Eigen::MatrixXd totals = load.by_block.colwise().sum();
  const double relative = error_of_mean(totals)[0] / totals.mean();
  return relative * relative;
}

}  // namespace

LinerReplicates same_liners(const LinerProfile& profile, Eigen::Index bins, Eigen::Index count) {
  return {profile, Eigen::MatrixXd::Zero(bins, count)};
}

LinerReplicates worn(const LinerReplicates& before, const UncertainLoad& load, double start,
                     double duration, const LinerProfile& after) {
  const Eigen::Index bins = before.deeper.rows();
  const double middle = start + 0.5 * duration;
  const auto onto_current = load.load.carrier().onto_bins(before.profile, bins);
  const Eigen::VectorXd rate = onto_current * load.load.rate(middle);
  Eigen::MatrixXd change = onto_current * load.load.sum(middle, load.newest, load.previous);
  change += rate * (load.growth * sections_ahead(before)).transpose();
  const Eigen::VectorXd mean = change.rowwise().mean();
  change = change.cwiseMax((-rate).replicate(1, change.cols()));
  change.colwise() += mean - change.rowwise().mean();
  const LoadCarrier along_surface(before.profile, bins);
  return {after, along_surface.onto_bins(after, bins) * (before.deeper + duration * change)};
}

LinerReplicates mirrored(const LinerReplicates& liners) {
  return {as_turned(liners.profile, Rotation::reversed),
          by_bin_as_turned(liners.deeper, Rotation::reversed)};
}

double growth_between(const TimedLoad& before, const TimedLoad& after) {
  const double section = steel_area(before.profile) - steel_area(after.profile);
  if (!(section > 0.0)) return 0.0;
  const double change = std::log(section_rate(after) / section_rate(before));
  const double noise = relative_variance(before) + relative_variance(after);
  const double believed = change != 0.0 ? std::max(0.0, 1.0 - noise / (change * change)) : 0.0;
  return believed * change / section;
}

Eigen::VectorXd lifter_heights(const LinerReplicates& liners) {
  const auto places = surface_of(liners);
  Eigen::VectorXd heights =
      Eigen::VectorXd::Constant(liners.deeper.cols(), lifter_height(liners.profile));
  for (Eigen::Index r = 0; r < heights.size(); ++r) {
    heights[r] -= radius_change(liners, places, r).least;
  }
  return heights;
}

Eigen::VectorXd plate_thicknesses(const LinerReplicates& liners) {
  const auto places = surface_of(liners);
  Eigen::VectorXd thicknesses =
      Eigen::VectorXd::Constant(liners.deeper.cols(), plate_thickness(liners.profile));
  for (Eigen::Index r = 0; r < thicknesses.size(); ++r) {
    thicknesses[r] -= radius_change(liners, places, r).greatest;
  }
  return thicknesses;
}

Eigen::VectorXd sections_ahead(const LinerReplicates& liners) {
  return bin_width(liners) * liners.deeper.colwise().sum().transpose();
}

}  // namespace millwear::wear
