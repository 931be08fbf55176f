#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mill/wall_contacts.h"
#include "wear/collision.h"

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
  double into_wall[3];   ///< of its latest contact
  double force_now;      ///< sum of the normal forces in the latest sample [N]
  double latest_time;    ///< [s]
  std::int64_t sample;   ///< the latest sample it was seen in
  std::uint32_t behind;  ///< next open collision of the same particle, + 1; 0 for none
};

/// Follows the collisions of every particle with the liner from sample to sample.
///
/// A contact goes on with an open collision of its particle whose direction, seen from the
/// particle's centre, is within 30 degrees of its own: so a ball that slides or rolls from one
/// triangle to the next is one collision, and a ball in the foot of a lifter that touches plate and
/// face is two. A collision ends with the first sample in which it is not seen.
class CollisionTracker {
 public:
  using Take = std::function<void(const Collision&)>;

  /// `particles` is the largest particle number, `sample_interval` in s; `ended` is called for
  /// every collision that ends.
  CollisionTracker(std::size_t particles, double sample_interval, Take ended);

  /// Contacts of one sample: begin, every contact, end. What is first seen in a sample `before` the
  /// measurement, began before it, and nothing is integrated there.
  enum class SampleKind { before, measured };
  void begin_sample(double time, SampleKind kind);
  /// Returns whether a collision begins with this contact.
  bool add(const WallContact& contact, const LinerPlace& place);
  void end_sample();

  /// Ends what is still open and flags it.
  void finish();

  /// Removes the open collisions of the particles for which `left` holds, to be `adopt`ed by the
  /// tracker of the rank that has them now.
  [[nodiscard]] std::vector<OpenCollision> release(const std::function<bool(std::uint32_t)>& left);
  void adopt(const OpenCollision& collision);

  [[nodiscard]] std::size_t open_count() const { return open_.size(); }

 private:
  OpenCollision* find(const WallContact& contact);
  void relink();

  double sample_interval_;
  Take ended_;
  std::vector<OpenCollision> open_;
  std::vector<std::uint32_t> first_of_particle_;  ///< by particle number, + 1; 0 for none
  double time_ = 0.0;
  SampleKind kind_ = SampleKind::measured;
  std::int64_t sample_ = 0;
};

}  // namespace millwear::wear
