#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "liggghts_inputs/decks/free_space.h"
#include "mill/case/case.h"

namespace millwear::liggghts {

/// Finds the free place nearest to a centre for particles of one class, on a lattice of half their
/// diameter. A place that was taken once is not looked at again, so nothing may leave the space
/// while this is in use.
class NearestPlace {
 public:
  /// `space` has to outlive this.
  NearestPlace(const FreeSpace& space, const Case& mill, std::size_t particle_class);

  /// None where the mill is full.
  [[nodiscard]] std::optional<Eigen::Vector3d> find(const Eigen::Vector3d& centre);

 private:
  struct Found {
    Eigen::Vector3d place;
    double squared_distance;
  };
  void look_at_ring(const Eigen::Vector3d& centre, long ring, std::optional<Found>& nearest);
  void look_at_line(const Eigen::Vector3d& centre, long i, long k, std::optional<Found>& nearest);
  [[nodiscard]] Eigen::Vector3d place_of(long i, long j, long k) const;

  const FreeSpace& space_;
  std::size_t class_;
  double half_;   ///< of the square that is looked at, x and z [m]
  double slice_;  ///< [m]
  double step_;   ///< of the lattice in x and z [m]
  long across_;   ///< places in x and in z
  long along_;    ///< places in y
  std::vector<char> is_taken_;
};

}  // namespace millwear::liggghts
