#pragma once
#include <Eigen/Core>

#include "mill/liner_profile.h"
#include "mill/wall_contacts.h"
#include "mill/wall_load.h"
#include "wear/charge_position.h"
#include "wear/profile_index.h"

namespace millwear::wear {

/// The load is recorded on so many cells a bin and the bins are laid after the run, see
/// `coarsened`.
inline constexpr int cells_per_bin = 8;

struct LoadMeasurement {
  int bins;                 ///< along one pitch, to be laid after the run
  std::size_t class_count;  ///< particle classes
  std::size_t block_count;  ///< time blocks of equal length
  double slice_length;      ///< [m]
  double duration;          ///< of the measurement [s]
  double sample_interval;   ///< simulated time that one sample stands for [s]
  double contact_limit;     ///< a contact farther from the profile than this is rejected [m]
};

/// Maps wall contacts onto the master lifter and sums them as they come.
///
/// Every contact is turned back by the mill's angle, folded by the pitch, and added to the cell
/// (an eighth of a bin) of the nearest place on the profile, to its particle class and to the time
/// block floor(t / duration * blocks):
///     samples += 1, normal_impulse += Fn dt, sliding_work += max(Fn, 0) |v_slip| dt,
///     normal_dissipation += Fn v_n dt.
/// The damping of a contact that ends may pull (Fn < 0): that dissipates, but abrades nothing.
/// A contact farther from the profile than `contact_limit` goes to `rejected`, so cells plus
/// rejected equal the sum over all contacts.
class LoadAccumulator {
 public:
  /// Throws InputError where a number of `measurement` is not positive.
  LoadAccumulator(const LinerProfile& profile, const LoadMeasurement& measurement);

  /// Throws ResultRejected for a time outside the measurement (one sample beyond its end still
  /// counts to the last block), an unknown particle class or a value that is not finite.
  void add(const WallContacts& sample);

  /// The load on bins * cells_per_bin cells.
  [[nodiscard]] const WallLoad& load() const { return load_; }

  /// Where around the mill the charge touches the liner; rejected contacts count too.
  [[nodiscard]] const ChargeAngles& charge_angles() const { return angles_; }

 private:
  [[nodiscard]] std::size_t block_of(double time) const;

  LinerSector sector_;
  LoadMeasurement measurement_;
  ProfileIndex index_;
  double cells_per_metre_;
  WallLoad load_;
  ChargeAngles angles_;
};

/// Joins every `factor` neighbouring bins of a load into one. Throws InputError if `factor` does
/// not divide their number.
[[nodiscard]] WallLoad coarsened(const WallLoad& load, int factor);

/// Sum of two loads on the same bins, e.g. of two ranks that saw different contacts of the same
/// measurement. Throws InputError if they differ in anything but their values.
[[nodiscard]] WallLoad sum_of(const WallLoad& first, const WallLoad& second);

/// Share of the contacts' normal impulse that was rejected, 0 ... 1; 0 for an empty load.
[[nodiscard]] double rejected_share(const WallLoad& load);

/// Throws ResultRejected if the rejected share of samples or of normal impulse is above `limit`.
void check_rejected_share(const WallLoad& load, double limit);

}  // namespace millwear::wear
