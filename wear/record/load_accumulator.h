#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "mill/load/load_measurement.h"
#include "mill/load/wall_contacts.h"
#include "mill/load/wall_load.h"
#include "wear/record/collision_tracker.h"
#include "wear/record/liner_record.h"
#include "wear/record/profile_index.h"

namespace millwear::wear {

/// The load is recorded on so many cells a bin and the bins are laid after the run, see
/// `coarsened`.
inline constexpr int cells_per_bin = 8;

/// Maps wall contacts onto the master lifter and sums them as they come.
///
/// Every contact is turned back by the mill's angle, folded by the pitch, and added to the cell
/// (an eighth of a bin) of the nearest place on the profile, to its particle class and to the time
/// block in which the middle of the sample's interval (t - dt, t] lies (dt is the measurement's, or
/// the sample's own where that differs):
///     samples += 1, normal_impulse += Fn dt, sliding_work += max(Fn, 0) v_slide dt,
///     path_work += max(Fn, 0) v_path dt, normal_dissipation += Fn v_n dt,
///     shear_dissipation, finnie += power dt,
/// and where a collision begins
///     events += 1, incident_energy += m v^2 / 2, excess_energy += m max(v - v_0, 0)^2 / 2.
/// The damping of a contact that ends may pull (Fn < 0): that dissipates, but abrades nothing.
/// A contact farther from the profile than `contact_limit` goes to `rejected`, so cells plus
/// rejected equal the sum over all contacts.
class LoadAccumulator {
 public:
  /// `ended` is called for every collision that ends. Throws InputError where a number of
  /// `measurement` is not positive.
  LoadAccumulator(const LinerProfile& profile, const LoadMeasurement& measurement,
                  CollisionTracker::Take ended = {});

  LoadAccumulator(const LoadAccumulator&) = delete;
  LoadAccumulator& operator=(const LoadAccumulator&) = delete;

  /// What touches the liner as the measurement begins, so that it is not taken for new; before the
  /// first `add`, if at all.
  void begin_with(const WallContacts& sample);

  /// Throws ResultRejected for a time outside the measurement (one sample beyond its end still
  /// counts to the last block), an unknown particle class or a value that is not finite.
  void add(const WallContacts& sample);

  /// Masses of the parts of the charge at one time [s] of the measurement, where motion is kept.
  void add_census(double time, const Census& census);

  /// The measurement goes on until `duration` [s] by further blocks of the same length; what comes
  /// then is the same as if it had been so long from the beginning. To be called before a sample
  /// beyond its former end. Throws InputError unless that makes a whole number of blocks, and more
  /// than there are.
  void go_on_until(double duration);

  /// The load of the samples taken so far.
  [[nodiscard]] const WallLoad& load_so_far();

  /// The end of the measurement: ends the open collisions, flagged, and gives what was summed.
  [[nodiscard]] LinerRecord finish();

  /// The collisions that are going on; they move to another rank with their particles.
  [[nodiscard]] CollisionTracker& collisions() { return tracker_; }

 private:
  struct Place {
    ProfilePlace on_profile;
    int row;
    double angle_from_six;  ///< of the mill at rest [rad]
  };
  using Amounts = Eigen::Array<double, static_cast<int>(measure_count), 1>;

  [[nodiscard]] std::size_t block_of(double time, double interval) const;
  [[nodiscard]] Place place_of(const WallContact& contact, double mill_angle) const;
  [[nodiscard]] LinerPlace liner_place(const Place& place) const;
  const std::vector<bool>& follow(const WallContacts& sample, CollisionTracker::SampleKind kind);
  void check(const WallContact& contact, double time) const;
  void take_ended(const Collision& collision);
  void add_polar_amounts(Eigen::Index bin, Eigen::Index column, const Amounts& amounts);
  void add_bare_hits(const WallContacts& sample, std::size_t block);
  void close_block();

  LinerSector sector_;
  LoadMeasurement measurement_;
  double block_duration_;  ///< [s]
  ProfileIndex index_;
  double cells_per_metre_;
  LinerRecord record_;
  CollisionTracker::Take ended_;
  CollisionTracker tracker_;
  std::vector<Place> places_;  ///< of the sample's contacts
  std::vector<LinerPlace> liner_places_;
  double plate_limit_;             ///< radius from which a hit is one on the plate [m]
  std::vector<std::size_t> hits_;  ///< contacts of the sample
  std::size_t block_ = 0;
  /// Sums of the current block, a column a cell and class: all measures of a contact lie together.
  Eigen::Array<double, static_cast<int>(measure_count), Eigen::Dynamic> block_sums_;
};

/// Joins every `factor` neighbouring bins of a load into one. `factor` divides their number
/// (std::logic_error).
[[nodiscard]] WallLoad coarsened(const WallLoad& load, int factor);

/// Share of the contacts' normal impulse that was rejected, 0 ... 1; 0 for an empty load.
[[nodiscard]] double rejected_share(const WallLoad& load);

/// Throws ResultRejected if the rejected share of samples or of normal impulse is above `limit`.
void check_rejected_share(const WallLoad& load, double limit);

}  // namespace millwear::wear
