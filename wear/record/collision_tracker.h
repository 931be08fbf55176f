#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "mill/load/wall_contacts.h"
#include "wear/record/collision.h"

namespace millwear::wear {

/// Where a contact lies on the liner.
struct LinerPlace {
  double arc_length;  ///< along the profile [m]; negative: off it
  int row;            ///< lifter
};

/// A collision that is still going on. Plain data, so that it can go with its particle to another
/// MPI rank.
struct OpenCollision {
  Collision so_far;
  double into_wall[3];   ///< sum of these unit vectors over its contacts in the latest sample
  double force_now;      ///< sum of their normal forces [N]
  double slip_now;       ///< of theirs the one farthest from zero [m/s]
  double latest_time;    ///< [s]
  std::int64_t sample;   ///< the latest sample it was seen in
  std::uint32_t behind;  ///< next open collision of the same particle, + 1; 0 for none
};

/// Follows the collisions of every particle with the liner from sample to sample.
///
/// A contact goes on with that open collision of its particle whose direction, seen from the
/// particle's centre, was nearest to its own in the sample before, if within 30 degrees: so a ball
/// that slides or rolls from one triangle to the next is one collision, and a ball in the foot of a
/// lifter that touches plate and face is two. Contacts that begin together within 30 degrees of the
/// first of them, by triangle, are one collision too. A collision ends with the first sample in
/// which it is not seen. The order of the contacts in a sample does not matter.
class CollisionTracker {
 public:
  using Take = std::function<void(const Collision&)>;

  /// `particles` is the largest particle number, `sample_interval` in s; `ended` is called for
  /// every collision that ends.
  CollisionTracker(std::size_t particles, double sample_interval, Take ended);

  /// What is first seen in a sample `before` the measurement, began before it, and nothing is
  /// integrated there.
  enum class SampleKind { before, measured };

  /// Takes all contacts of one sample, with a place for each. Returns for each whether a collision
  /// begins with it. `interval` [s] is the time that the sample stands for, where that is not the
  /// tracker's own. Throws ResultRejected for a particle that the charge does not have.
  const std::vector<bool>& add(double time, SampleKind kind, std::span<const WallContact> contacts,
                               std::span<const LinerPlace> places,
                               std::optional<double> interval = {});

  /// For each contact of the latest sample whether a collision begins with it and the particle did
  /// not touch the liner in the sample before.
  [[nodiscard]] const std::vector<bool>& arrives() const { return arrives_; }

  /// Ends what is still open and flags it.
  void finish();

  /// Removes the open collisions of the particles for which `left` holds, to be `adopt`ed by the
  /// tracker of the rank that has them now.
  [[nodiscard]] std::vector<OpenCollision> release(const std::function<bool(std::uint32_t)>& left);
  void adopt(const OpenCollision& collision);

  [[nodiscard]] std::size_t open_count() const { return open_.size(); }

 private:
  [[nodiscard]] std::size_t nearest_open(const WallContact& contact) const;
  void open(const OpenCollision& collision);
  void add_to(OpenCollision& collision, const WallContact& contact, double time, SampleKind kind,
              double interval);
  void end_sample(double interval);
  void relink();

  double sample_interval_;
  Take ended_;
  std::vector<OpenCollision> open_;
  std::vector<std::uint32_t> first_of_particle_;  ///< by particle number, + 1; 0 for none
  std::int64_t sample_ = 0;
  std::vector<std::size_t> collision_of_;  ///< by contact of the sample
  std::vector<bool> begins_;               ///< by contact of the sample
  std::vector<bool> arrives_;              ///< by contact of the sample
  std::vector<std::size_t> unmatched_;     ///< contacts that go on with no open collision
};

}  // namespace millwear::wear
