#include "liggghts_inputs/decks/nearest_place.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace millwear::liggghts {

NearestPlace::NearestPlace(const FreeSpace& space, const Case& mill, std::size_t particle_class)
    : space_(space),
      class_(particle_class),
      half_(mill.liner.sector.shell_radius),
      slice_(mill.slice_length),
      step_(0.5 * mill.charge.classes[particle_class].diameter),
      across_(static_cast<long>(2.0 * half_ / step_) + 1),
      along_(std::max(1L, std::lround(slice_ / step_))),
      is_taken_(static_cast<std::size_t>(across_ * across_ * along_), 0) {}

Eigen::Vector3d NearestPlace::place_of(long i, long j, long k) const {
  return {static_cast<double>(i) * step_ - half_,
          static_cast<double>(j) * slice_ / static_cast<double>(along_),
          static_cast<double>(k) * step_ - half_};
}

void NearestPlace::look_at_line(const Eigen::Vector3d& centre, long i, long k,
                                std::optional<Found>& nearest) {
  if (i < 0 || i >= across_ || k < 0 || k >= across_) return;
  for (long j = 0; j < along_; ++j) {
    char& taken = is_taken_[static_cast<std::size_t>((i * across_ + k) * along_ + j)];
    if (taken != 0) continue;
    const Eigen::Vector3d place = place_of(i, j, k);
    Eigen::Vector3d apart = place - centre;
    apart.y() -= slice_ * std::round(apart.y() / slice_);
    if (nearest && apart.squaredNorm() >= nearest->squared_distance) continue;
    if (space_.is_free(place, class_))
      nearest = Found{place, apart.squaredNorm()};
    else
      taken = 1;
  }
}

void NearestPlace::look_at_ring(const Eigen::Vector3d& centre, long ring,
                                std::optional<Found>& nearest) {
  const long i = std::lround((centre.x() + half_) / step_);
  const long k = std::lround((centre.z() + half_) / step_);
  for (long a = -ring; a <= ring; ++a) {
    const bool is_side = std::abs(a) == ring;
    for (long b = -ring; b <= ring; b += is_side || ring == 0 ? 1 : 2 * ring)
      look_at_line(centre, i + a, k + b, nearest);
  }
}

std::optional<Eigen::Vector3d> NearestPlace::find(const Eigen::Vector3d& centre) {
  std::optional<Found> nearest;
  for (long ring = 0; ring <= across_; ++ring) {
    const double least = (static_cast<double>(ring) - 0.5) * step_;
    if (nearest && least > 0.0 && least * least > nearest->squared_distance) break;
    look_at_ring(centre, ring, nearest);
  }
  if (!nearest) return std::nullopt;
  return nearest->place;
}

}  // namespace millwear::liggghts
