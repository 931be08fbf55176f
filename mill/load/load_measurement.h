#pragma once
#include <cstddef>
#include <vector>

namespace millwear {

struct Case;

/// Whether the motion of the charge is recorded beside the load: the hits on the bare liner, for
/// which contacts have to know their company, and the census.
enum class MotionRecord { none, kept };

/// What a measurement of the load on the liner is made of.
struct LoadMeasurement {
  int bins;                        ///< along one pitch, to be laid after the run
  std::vector<double> class_mass;  ///< of one particle of each class [kg]
  std::size_t particles;           ///< the largest particle number
  std::size_t triangles = 0;       ///< of the mesh; 0 keeps no sums by triangle
  std::size_t block_count;         ///< time blocks of equal length
  double slice_length;             ///< [m]
  double duration;                 ///< of the measurement [s]
  double sample_interval;          ///< simulated time that one sample stands for [s]
  double contact_limit;            ///< a contact farther from the profile than this is rejected [m]
  double excess_speed = 0.0;       ///< v_0 of the excess kinetic energy [m/s]
  MotionRecord motion = MotionRecord::none;
};

/// The measurement of a case over `duration` with a sample every `sample_interval` [s]. A contact
/// counts as long as it lies no farther from the profile than the mesh and an overlap can bring it.
[[nodiscard]] LoadMeasurement load_measurement(const Case& mill, double duration,
                                               double sample_interval, std::size_t triangles);

}  // namespace millwear
