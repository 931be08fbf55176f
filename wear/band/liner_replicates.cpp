#include "wear/band/liner_replicates.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mill/liner/profile_measures.h"
#include "mill/liner/rotation.h"
#include "wear/numerics/arc_curve.h"
#include "wear/surface/centre_path.h"
#include "wear/surface/edges.h"

namespace millwear::wear {
namespace {

/// A turn within a bin from which on two faces meet at an edge [rad].
constexpr double least_edge = std::numbers::pi / 7.2;

double bin_width(const LinerReplicates& liners) {
  return arc_lengths(liners.profile).back() / static_cast<double>(liners.deeper.rows());
}

/// A place of the surface, and how far it moves with the depths of two bins: at the centre of a bin
/// along its normal, at an edge to where the two faces meet anew.
struct SurfacePlace {
  Eigen::Vector2d position;
  Eigen::Index before;
  Eigen::Index after;
  Eigen::Vector2d with_before;  ///< movement per depth of the bin before
  Eigen::Vector2d with_after;

  [[nodiscard]] Eigen::Vector2d moved(const Eigen::MatrixXd& deeper, Eigen::Index replicate) const {
    return position + deeper(before, replicate) * with_before +
           deeper(after, replicate) * with_after;
  }
};

Eigen::Vector2d inward_normal(const LinerProfile& profile, const std::vector<double>& lengths,
                              double from, double to) {
  const Eigen::Vector2d along = place_at(profile, lengths, to) - place_at(profile, lengths, from);
  return Eigen::Vector2d(along.y(), -along.x()).normalized();
}

std::vector<SurfacePlace> surface_of(const LinerReplicates& liners) {
  const auto lengths = arc_lengths(liners.profile);
  const double width = bin_width(liners);
  std::vector<SurfacePlace> places;
  for (Eigen::Index bin = 0; bin < liners.deeper.rows(); ++bin) {
    const double left = static_cast<double>(bin) * width;
    places.push_back(
        {place_at(liners.profile, lengths, left + 0.5 * width), bin, bin,
         inward_normal(liners.profile, lengths, left + 0.01 * width, left + 0.99 * width),
         Eigen::Vector2d::Zero()});
  }
  for (const Edge& edge : edges_of(liners.profile, width, least_edge)) {
    const bool is_foot = edge.turn < 0.0;
    if (is_foot) continue;
    const double s = edge.arc_length;
    const auto beside = bins_beside(s, width, liners.deeper.rows());
    Eigen::Matrix2d normals;
    normals << inward_normal(liners.profile, lengths, s - width, s).transpose(),
        inward_normal(liners.profile, lengths, s, s + width).transpose();
    const Eigen::Matrix2d meets = normals.inverse();
    places.push_back({place_at(liners.profile, lengths, s), beside.left, beside.right, meets.col(0),
                      meets.col(1)});
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
  for (const SurfacePlace& place : places) {
    const double before = radius_of(sector, place.position);
    const double after = radius_of(sector, place.moved(liners.deeper, replicate));
    least_before = std::min(least_before, before);
    greatest_before = std::max(greatest_before, before);
    least = std::min(least, after);
    greatest = std::max(greatest, after);
  }
  return {least - least_before, greatest - greatest_before};
}

/// The displacements `deeper` after balls have worn a depth of `worn` on a flat: they change the
/// curvature by d2d/ds2 + kappa^2 d (a crest that moves as a whole keeps its own), and with it what
/// is worn, d = deeper + worn r (d2d/ds2 + kappa^2 d).
Eigen::MatrixXd levelled(const LinerProfile& profile, const Eigen::MatrixXd& deeper,
                         const Eigen::VectorXd& worn, double ball_radius) {
  if (ball_radius == 0.0) return deeper;
  const Eigen::Index bins = deeper.rows();
  const double width = arc_lengths(profile).back() / static_cast<double>(bins);
  const Eigen::ArrayXd spread = ball_radius * worn.array();
  const Eigen::ArrayXd curvature = curvature_along(profile, bins, 2.0 * ball_radius);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(bins, bins);
  for (Eigen::Index bin = 0; bin < bins; ++bin) {
    const double share = spread[bin] / (width * width);
    matrix(bin, bin) += 2.0 * share - spread[bin] * curvature[bin] * curvature[bin];
    matrix(bin, (bin + 1) % bins) -= share;
    matrix(bin, (bin + bins - 1) % bins) -= share;
  }
  return matrix.partialPivLu().solve(deeper);
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
  const Eigen::VectorXd rate = onto_current * load.load.per_path(middle);
  Eigen::MatrixXd change = onto_current * load.load.sum(middle, load.newest, load.previous);
  change = centre_path(before.profile, bins, load.load.balls()).asDiagonal() * change;
  if (load.growth.size() > 0) change += (onto_current * load.growth).asDiagonal() * before.deeper;
  const Eigen::MatrixXd deeper = levelled(before.profile, before.deeper + duration * change,
                                          duration * rate, load.load.balls().mean);
  const LoadCarrier along_surface(before.profile, bins);
  return {after, along_surface.onto_bins(after, bins) * deeper};
}

LinerReplicates mirrored(const LinerReplicates& liners) {
  return {as_turned(liners.profile, Rotation::reversed),
          by_bin_as_turned(liners.deeper, Rotation::reversed)};
}

Eigen::VectorXd growth_between(const TimedLoad& before, const TimedLoad& after,
                               const LinerProfile& liner) {
  const auto on_liner = [&](const TimedLoad& load) -> Eigen::ArrayXd {
    const Eigen::Index bins = load.rate.values.size();
    return LoadCarrier(load.profile, bins).onto_bins(liner, bins) * per_path(load);
  };
  const Eigen::ArrayXd first = on_liner(before);
  const Eigen::ArrayXd last = on_liner(after);
  const ZonedLoad first_zones = zoned(before, liner);
  const ZonedLoad last_zones = zoned(after, liner);
  const double change = (last_zones.rate - first_zones.rate).squaredNorm();
  const double noise = (first_zones.variance + last_zones.variance).sum();
  const double believed = change > 0.0 ? std::max(0.0, 1.0 - noise / change) : 0.0;
  const Eigen::ArrayXd mean = 0.5 * (first + last);
  const Eigen::ArrayXd growth = (last - first) / mean / (after.time - before.time);
  return (mean > 0.0).select(believed * growth, 0.0);
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
