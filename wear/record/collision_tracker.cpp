#include "wear/record/collision_tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

constexpr double cosine_of_same_side = 0.8660254037844386;  // 30 degrees
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

Unfinished with(Unfinished flags, Unfinished more) {
  return static_cast<Unfinished>(static_cast<int>(flags) | static_cast<int>(more));
}

double impact_angle(const WallContact& contact) {
  return contact.impact_speed > 0.0
             ? std::asin(std::clamp(contact.impact_normal_speed / contact.impact_speed, 0.0, 1.0))
             : 0.0;
}

OpenCollision begun(const WallContact& contact, const LinerPlace& place, double time,
                    CollisionTracker::SampleKind kind) {
  OpenCollision fresh{};
  fresh.so_far.start = time;
  fresh.so_far.arc_length = place.arc_length;
  fresh.so_far.axial_place = contact.point.y();
  fresh.so_far.impact_speed = contact.impact_speed;
  fresh.so_far.impact_angle = impact_angle(contact);
  fresh.so_far.particle = static_cast<std::uint32_t>(contact.particle);
  fresh.so_far.particle_class = static_cast<std::uint32_t>(contact.particle_class);
  fresh.so_far.row = place.row;
  if (kind == CollisionTracker::SampleKind::before)
    fresh.so_far.unfinished = Unfinished::began_before;
  std::copy_n(contact.into_wall.data(), 3, fresh.into_wall);
  return fresh;
}

/// An order of one particle's contacts that does not depend on how they came.
auto order_of(const WallContact& contact) {
  return std::tuple(contact.particle, contact.triangle, contact.into_wall.x(),
                    contact.into_wall.y(), contact.into_wall.z());
}

}  // namespace

CollisionTracker::CollisionTracker(std::size_t particles, double sample_interval, Take ended)
    : sample_interval_(sample_interval),
      ended_(std::move(ended)),
      first_of_particle_(particles + 1, 0) {}

std::size_t CollisionTracker::nearest_open(const WallContact& contact) const {
  std::size_t nearest = none;
  double best = cosine_of_same_side;
  for (std::size_t at = first_of_particle_[contact.particle]; at != 0; at = open_[at - 1].behind) {
    const Eigen::Map<const Eigen::Vector3d> side(open_[at - 1].into_wall);
    const double cosine = side.dot(contact.into_wall) / side.norm();
    if (cosine < best) continue;
    best = cosine;
    nearest = at - 1;
  }
  return nearest;
}

void CollisionTracker::open(const OpenCollision& collision) {
  open_.push_back(collision);
  std::uint32_t& first = first_of_particle_[collision.so_far.particle];
  open_.back().behind = first;
  first = static_cast<std::uint32_t>(open_.size());
}

const std::vector<bool>& CollisionTracker::add(double time, SampleKind kind,
                                               std::span<const WallContact> contacts,
                                               std::span<const LinerPlace> places,
                                               std::optional<double> interval) {
  const double dt = interval.value_or(sample_interval_);
  ++sample_;
  begins_.assign(contacts.size(), false);
  arrives_.assign(contacts.size(), false);
  collision_of_.clear();
  unmatched_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].particle == 0 || contacts[i].particle >= first_of_particle_.size())
      throw ResultRejected(fmt::format("a wall contact of particle {}; the charge has {}",
                                       contacts[i].particle, first_of_particle_.size() - 1));
    collision_of_.push_back(nearest_open(contacts[i]));
    if (collision_of_.back() != none) continue;
    unmatched_.push_back(i);
    arrives_[i] = first_of_particle_[contacts[i].particle] == 0;
  }
  std::ranges::sort(unmatched_, {}, [&](std::size_t i) { return order_of(contacts[i]); });
  for (const std::size_t i : unmatched_) {
    collision_of_[i] = nearest_open(contacts[i]);
    arrives_[i] = arrives_[i] && collision_of_[i] == none && kind == SampleKind::measured;
    if (collision_of_[i] != none) continue;
    collision_of_[i] = open_.size();
    begins_[i] = kind == SampleKind::measured;
    open(begun(contacts[i], places[i], time, kind));
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
    add_to(open_[collision_of_[i]], contacts[i], time, kind, dt);
  end_sample(dt);
  return begins_;
}

void CollisionTracker::add_to(OpenCollision& collision, const WallContact& contact, double time,
                              SampleKind kind, double interval) {
  if (collision.sample != sample_) {
    collision.sample = sample_;
    collision.latest_time = time;
    collision.force_now = 0.0;
    collision.slip_now = 0.0;
    std::fill_n(collision.into_wall, 3, 0.0);
  }
  Eigen::Map<Eigen::Vector3d>(collision.into_wall) += contact.into_wall;
  if (kind == SampleKind::before) return;
  Collision& sum = collision.so_far;
  collision.force_now += contact.normal_force;
  if (std::abs(contact.slip_speed) > std::abs(collision.slip_now))
    collision.slip_now = contact.slip_speed;
  sum.normal_dissipation += contact.normal_force * contact.normal_speed * interval;
  sum.sliding_work += std::max(contact.normal_force, 0.0) * contact.slip_speed * interval;
  sum.shear_dissipation += contact.shear_power * interval;
}

void CollisionTracker::end_sample(double interval) {
  const std::size_t before = open_.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < before; ++i) {
    if (open_[i].sample == sample_) {
      Collision& sum = open_[i].so_far;
      sum.largest_normal_force = std::max(sum.largest_normal_force, open_[i].force_now);
      sum.slip_distance += open_[i].slip_now * interval;
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
  open(collision);
  open_.back().sample = sample_;
}

}  // namespace millwear::wear
