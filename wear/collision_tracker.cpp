#include "wear/collision_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/failure.h"

namespace millwear::wear {
namespace {

constexpr double cosine_of_same_side = 0.8660254037844386;  // 30 degrees

Unfinished with(Unfinished flags, Unfinished more) {
  return static_cast<Unfinished>(static_cast<int>(flags) | static_cast<int>(more));
}

Collision begun(const WallContact& contact, const LinerPlace& place, double time) {
  Collision collision{};
  collision.start = time;
  collision.arc_length = place.arc_length;
  collision.axial_place = contact.point.y();
  collision.impact_speed = contact.impact_speed;
  collision.impact_angle =
      contact.impact_speed > 0.0
          ? std::asin(std::clamp(contact.impact_normal_speed / contact.impact_speed, 0.0, 1.0))
          : 0.0;
  collision.particle = static_cast<std::uint32_t>(contact.particle);
  collision.particle_class = static_cast<std::uint32_t>(contact.particle_class);
  collision.row = place.row;
  return collision;
}

}  // namespace

CollisionTracker::CollisionTracker(std::size_t particles, double sample_interval, Take ended)
    : sample_interval_(sample_interval),
      ended_(std::move(ended)),
      first_of_particle_(particles + 1, 0) {}

void CollisionTracker::begin_sample(double time, SampleKind kind) {
  time_ = time;
  kind_ = kind;
  ++sample_;
}

OpenCollision* CollisionTracker::find(const WallContact& contact) {
  OpenCollision* nearest = nullptr;
  double best = cosine_of_same_side;
  for (std::uint32_t at = first_of_particle_[contact.particle]; at != 0;) {
    OpenCollision& open = open_[at - 1];
    const double cosine = open.into_wall[0] * contact.into_wall.x() +
                          open.into_wall[1] * contact.into_wall.y() +
                          open.into_wall[2] * contact.into_wall.z();
    if (cosine >= best) {
      best = cosine;
      nearest = &open;
    }
    at = open.behind;
  }
  return nearest;
}

bool CollisionTracker::add(const WallContact& contact, const LinerPlace& place) {
  if (contact.particle == 0 || contact.particle >= first_of_particle_.size())
    throw ResultRejected(fmt::format("a wall contact of particle {}; the charge has {}",
                                     contact.particle, first_of_particle_.size() - 1));
  OpenCollision* open = find(contact);
  const bool begins = open == nullptr;
  if (begins) {
    OpenCollision fresh{};
    fresh.so_far = begun(contact, place, time_);
    if (kind_ == SampleKind::before) fresh.so_far.unfinished = Unfinished::began_before;
    fresh.behind = first_of_particle_[contact.particle];
    open_.push_back(fresh);
    first_of_particle_[contact.particle] = static_cast<std::uint32_t>(open_.size());
    open = &open_.back();
  }
  if (open->sample != sample_) {
    open->sample = sample_;
    open->force_now = 0.0;
  }
  std::copy_n(contact.into_wall.data(), 3, open->into_wall);
  open->latest_time = time_;
  if (kind_ == SampleKind::before) return false;
  Collision& sum = open->so_far;
  const double dt = sample_interval_;
  open->force_now += contact.normal_force;
  sum.largest_normal_force = std::max(sum.largest_normal_force, open->force_now);
  sum.normal_dissipation += contact.normal_force * contact.normal_speed * dt;
  sum.sliding_work += std::max(contact.normal_force, 0.0) * contact.slip_speed * dt;
  sum.shear_dissipation += contact.shear_power * dt;
  sum.slip_distance += contact.slip_speed * dt;
  return begins;
}

void CollisionTracker::end_sample() {
  const std::size_t before = open_.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (open_[i].sample == sample_) {
      if (kept != i) open_[kept] = open_[i];
      ++kept;
      continue;
    }
    first_of_particle_[open_[i].so_far.particle] = 0;
    open_[i].so_far.end = open_[i].latest_time;
    ended_(open_[i].so_far);
  }
  if (kept == before) return;
  open_.resize(kept);
  relink();
}

void CollisionTracker::relink() {
  for (const auto& open : open_) first_of_particle_[open.so_far.particle] = 0;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    std::uint32_t& first = first_of_particle_[open_[i].so_far.particle];
    open_[i].behind = first;
    first = static_cast<std::uint32_t>(i + 1);
  }
}

void CollisionTracker::finish() {
  for (auto& open : open_) {
    first_of_particle_[open.so_far.particle] = 0;
    open.so_far.end = open.latest_time;
    open.so_far.unfinished = with(open.so_far.unfinished, Unfinished::open_at_end);
    ended_(open.so_far);
  }
  open_.clear();
}

std::vector<OpenCollision> CollisionTracker::release(
    const std::function<bool(std::uint32_t)>& left) {
  std::vector<OpenCollision> released;
  const auto stays = std::stable_partition(
      open_.begin(), open_.end(), [&](const auto& open) { return !left(open.so_far.particle); });
  for (auto open = stays; open != open_.end(); ++open) {
    first_of_particle_[open->so_far.particle] = 0;
    released.push_back(*open);
  }
  open_.erase(stays, open_.end());
  relink();
  return released;
}

void CollisionTracker::adopt(const OpenCollision& collision) {
  open_.push_back(collision);
  open_.back().sample = sample_;
  relink();
}

}  // namespace millwear::wear
