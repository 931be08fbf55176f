#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

namespace millwear {

/// What is accumulated on every bin of the liner. Rates are integrated over simulated time and
/// summed over all lifters and the whole slice length. docs/physics.md says what each stands for.
enum class Measure {
  samples,         ///< contacts seen in samples [-]
  events,          ///< collisions that began, see wear/record/collision_tracker.h [-]
  normal_impulse,  ///< int Fn dt [N s]
  sliding_work,    ///< int max(Fn, 0) v_slide dt, see `sliding_speed` [J]
  path_work,       ///< int max(Fn, 0) |v_slip| dt at the limit of friction, see `path_speed` [J]
  normal_dissipation,  ///< int Fn v_n dt, v_n the closing speed [J]
  shear_dissipation,   ///< int -Ft . v_slip dt [J]
  incident_energy,     ///< sum over collisions of m v^2 / 2, v of the centre as they begin [J]
  excess_energy,       ///< sum over collisions of m max(v - v_0, 0)^2 / 2 [J]
  finnie,              ///< int 2 f(a) |v| |F| dt while approaching, a the angle of impact [J]
};
inline constexpr std::size_t measure_count = 10;
inline constexpr std::array<std::string_view, measure_count> measure_names = {
    "samples",           "events",
    "normal_impulse",    "sliding_work",
    "path_work",         "normal_dissipation",
    "shear_dissipation", "incident_energy",
    "excess_energy",     "finnie"};
inline constexpr std::array<std::string_view, measure_count> measure_units = {
    "1", "1", "N s", "J", "J", "J", "J", "J", "J", "J"};

[[nodiscard]] constexpr std::size_t index_of(Measure measure) {
  return static_cast<std::size_t>(measure);
}

/// The load on the master lifter by bin, particle class and time block.
struct WallLoad {
  double slice_length;        ///< [m]
  int rows;                   ///< lifters summed over
  double duration;            ///< simulated time measured [s]
  Eigen::VectorXd bin_edges;  ///< arc length along the profile [m], size bins + 1, from 0
  std::size_t class_count;
  std::size_t block_count;
  /// values[measure](bin, particle_class * block_count + block)
  std::array<Eigen::MatrixXd, measure_count> values;
  /// the same measures of contacts that no bin took
  std::array<double, measure_count> rejected;

  [[nodiscard]] Eigen::Index bins() const { return bin_edges.size() - 1; }
  /// Width of every bin along the profile [m], size bins().
  [[nodiscard]] Eigen::VectorXd bin_widths() const;
  /// Surface of every bin on one lifter [m2], size bins().
  [[nodiscard]] Eigen::VectorXd bin_area() const;
  /// Sum over classes and blocks, size bins().
  [[nodiscard]] Eigen::VectorXd total(Measure measure) const;
  /// Sum over classes, bins() x block_count.
  [[nodiscard]] Eigen::MatrixXd by_block(Measure measure) const;
};

/// How much farther than they slid the contacts at the limit of friction went, weighted by their
/// normal force: `path_work` over `sliding_work` of the whole liner. 1 where the time step resolves
/// every contact; beyond that, jammed particles shake. NaN where nothing slid.
[[nodiscard]] double path_over_slip(const WallLoad& load);

}  // namespace millwear
