#pragma once
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "wear/record/liner_record.h"

namespace millwear::wear {

/// Two particles touching at one instant.
struct PairContact {
  std::uint32_t first, second;              ///< particle numbers, first < second
  std::uint32_t first_class, second_class;  ///< particle classes
  double normal_power;                      ///< Fn v_n, v_n the closing speed [W]
  double shear_power;                       ///< -Ft . v_slip [W]
  double rolling_power;                     ///< of the rolling torque on the relative spin [W]
};

/// A collision of two particles that is still going on. Plain data, so that it can go with its
/// first particle to another MPI rank.
struct OpenPair {
  std::uint32_t first, second;
  std::int32_t group;  ///< `pair_group` of the classes
  bool began_before;
  std::int64_t sample;  ///< the latest it was seen in
  double normal_energy, shear_energy;
};

/// Follows the collisions between particles from sample to sample, over a window in which every
/// step is a sample. What touches in the first sample began before the window. Each pair is to be
/// added once, by the rank that has its first particle.
class PairTracker {
 public:
  /// `duration` and `sample_interval` in s.
  PairTracker(std::size_t class_count, double duration, double sample_interval);

  void begin_sample();
  void add(const PairContact& contact);
  void end_sample();

  /// Ends what is still open, flagged, and gives what was summed.
  [[nodiscard]] PairRecord finish();

  /// Removes the open collisions whose first particle `left`, to be `adopt`ed by the rank that has
  /// it now.
  [[nodiscard]] std::vector<OpenPair> release(const std::function<bool(std::uint32_t)>& left);
  void adopt(const OpenPair& pair);

 private:
  void close(const OpenPair& pair);

  double sample_interval_;
  Eigen::Index class_count_;
  PairRecord record_;
  std::unordered_map<std::uint64_t, OpenPair> open_;
  std::int64_t sample_ = 0;
};

}  // namespace millwear::wear
