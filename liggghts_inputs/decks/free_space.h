#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "mill/case/case.h"

namespace millwear::liggghts {

/// The mill's inside (at mill angle 0) and what stands in it: where there is room for one more
/// particle. y is periodic.
class FreeSpace {
 public:
  /// An empty mill with the liner and the classes of the case.
  explicit FreeSpace(const Case& mill);

  /// Whether a particle's centre may be at a place [m] for all that the liner says: outside of the
  /// steel, and not deeper into its surface than `overlap` [m].
  [[nodiscard]] bool is_clear_of_liner(const Eigen::Vector3d& centre, std::size_t particle_class,
                                       double overlap) const;

  /// Whether it would touch neither the liner nor a particle that was put there.
  [[nodiscard]] bool is_free(const Eigen::Vector3d& centre, std::size_t particle_class) const;

  /// Puts a particle there, whether or not it is free.
  void take(const Eigen::Vector3d& centre, std::size_t particle_class);

 private:
  /// Particles of one class by cells of their own diameter.
  class ClassGrid {
   public:
    ClassGrid(double diameter, double slice_length);
    void insert(const Eigen::Vector3d& centre);
    [[nodiscard]] bool touches(const Eigen::Vector3d& centre, double diameter) const;

   private:
    [[nodiscard]] long cell(double x) const;
    [[nodiscard]] long cell_y(double y) const;
    [[nodiscard]] long wrapped(long j) const { return ((j % cells_y_) + cells_y_) % cells_y_; }
    [[nodiscard]] bool cell_touches(std::uint64_t cell_key, const Eigen::Vector3d& centre,
                                    double reach) const;

    double diameter_;
    double slice_;
    long cells_y_;
    std::unordered_map<std::uint64_t, std::vector<Eigen::Vector3d>> cells_;
  };

  LinerProfile liner_;
  double crest_;    ///< least distance of the steel from the axis [m]
  double deepest_;  ///< the greatest [m]
  std::vector<double> diameters_;
  std::vector<ClassGrid> grids_;
};

}  // namespace millwear::liggghts
