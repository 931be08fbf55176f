#include "wear/surface/closing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mill/base/contract.h"
#include "wear/record/profile_index.h"
#include "wear/surface/along_profile.h"

namespace millwear::wear {
namespace {

constexpr double place_share_of_radius = 0.25;
constexpr double widest_fan_step = std::numbers::pi / 12.0;
constexpr double widest_facet = std::numbers::pi / 18.0;
constexpr double reach_in_radii = 1.1;
constexpr int bisections = 24;
constexpr double same_place = 1e-9;

Eigen::Vector2d turned(const Eigen::Vector2d& vector, double angle) {
  return Eigen::Rotation2Dd(angle) * vector;
}

/// A straight piece of the surface, or an edge about which the ball turns.
struct Piece {
  Eigen::Vector2d start;
  Eigen::Vector2d along;   ///< zero at an edge [m]
  Eigen::Vector2d normal;  ///< out of the steel, at the beginning
  double turn;             ///< of the normal over the piece [rad]
  double arc_length;       ///< at the beginning [m]

  [[nodiscard]] Eigen::Vector2d place(double share) const { return start + share * along; }
  [[nodiscard]] Eigen::Vector2d normal_at(double share) const {
    return turned(normal, share * turn);
  }
  [[nodiscard]] double arc_at(double share) const { return arc_length + share * along.norm(); }
};

std::vector<Piece> pieces_of(const LinerProfile& profile) {
  const auto& nodes = profile.nodes;
  const Eigen::Vector2d before = shifted_by_pitches(profile.sector, nodes[nodes.size() - 2], -1);
  Eigen::Vector2d last = (nodes.front() - before).normalized();
  std::vector<Piece> pieces;
  double arc_length = 0.0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Eigen::Vector2d along = nodes[i + 1] - nodes[i];
    if (!(along.norm() > 0.0)) continue;
    const Eigen::Vector2d direction = along.normalized();
    const double turn = turn_between(last, direction);
    const Eigen::Vector2d normal(-direction.y(), direction.x());
    if (turn < 0.0)
      pieces.push_back(
          {nodes[i], Eigen::Vector2d::Zero(), turned(normal, -turn), turn, arc_length});
    pieces.push_back({nodes[i], along, normal, 0.0, arc_length});
    arc_length += along.norm();
    last = direction;
  }
  return pieces;
}

struct Sample {
  const Piece* piece;
  double share;
  bool touched;

  [[nodiscard]] Eigen::Vector2d place() const { return piece->place(share); }
  [[nodiscard]] double arc_length() const { return piece->arc_at(share); }
};

/// A ball of one radius on a liner.
class Ball {
 public:
  Ball(const LinerProfile& profile, double radius)
      : radius_(radius), index_(profile, reach_in_radii * radius, grid_for_hundreds) {}

  [[nodiscard]] double radius() const { return radius_; }

  [[nodiscard]] Eigen::Vector2d centre(const Sample& sample) const {
    return sample.place() + radius_ * sample.piece->normal_at(sample.share);
  }

  [[nodiscard]] bool touches(const Piece& piece, double share) const {
    const Eigen::Vector2d at = piece.place(share) + radius_ * piece.normal_at(share);
    return index_.nearest(at).distance >= (1.0 - touched_within) * radius_;
  }

  /// The last touched place between one that is touched and one that is not.
  [[nodiscard]] Sample last_touched(const Sample& touched, const Sample& beyond) const {
    if (touched.piece != beyond.piece) return touched;
    Sample found = touched;
    double free = touched.share;
    double blocked = beyond.share;
    for (int i = 0; i < bisections; ++i) {
      const double middle = 0.5 * (free + blocked);
      (touches(*touched.piece, middle) ? free : blocked) = middle;
    }
    found.share = free;
    return found;
  }

 private:
  double radius_;
  ProfileIndex index_;
};

std::vector<Sample> samples_on(const std::vector<Piece>& pieces, const Ball& ball) {
  std::vector<Sample> samples;
  for (const Piece& piece : pieces) {
    const double steps = std::max(piece.along.norm() / (place_share_of_radius * ball.radius()),
                                  std::abs(piece.turn) / widest_fan_step);
    const int count = std::max(1, static_cast<int>(std::ceil(steps)));
    for (int i = 0; i <= count; ++i) {
      const double share = static_cast<double>(i) / count;
      samples.push_back({&piece, share, ball.touches(piece, share)});
    }
  }
  return samples;
}

/// The arc of the ball between two places that it touches, without these.
std::vector<Eigen::Vector2d> arc_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                         const Eigen::Vector2d& centre) {
  const Eigen::Vector2d first = from - centre;
  const double angle = turn_between(first, to - centre);
  const int facets = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / widest_facet)));
  std::vector<Eigen::Vector2d> nodes;
  for (int i = 1; i < facets; ++i) nodes.push_back(centre + turned(first, angle * i / facets));
  return nodes;
}

}  // namespace

Closing closing_of(const LinerProfile& profile, double radius) {
  expect(radius > 0.0, "a ball that rolls over a liner has a radius above zero");
  const auto pieces = pieces_of(profile);
  const Ball ball(profile, radius);
  const auto samples = samples_on(pieces, ball);
  const auto is_touched = [](const Sample& sample) { return sample.touched; };
  const auto first = std::find_if(samples.begin(), samples.end(), is_touched);
  if (first == samples.end() || std::all_of(samples.begin(), samples.end(), is_touched))
    return {profile, {}, {}};

  const std::size_t begin = static_cast<std::size_t>(first - samples.begin());
  Closing closing{{profile.sector, {}}, {}, {}};
  auto& nodes = closing.surface.nodes;
  double way = 0.0;
  const auto add = [&](const Eigen::Vector2d& place, int pitch) {
    const Eigen::Vector2d here =
        pitch == 0 ? place : shifted_by_pitches(profile.sector, place, pitch);
    const double step = nodes.empty() ? 0.0 : (here - nodes.back()).norm();
    if (!nodes.empty() && step <= same_place) return;
    nodes.push_back(here);
    way += step;
  };
  const double length = arc_lengths(profile).back();
  Sample before_shadow = *first;
  add(first->place(), 0);
  for (std::size_t i = 1; i <= samples.size(); ++i) {
    const int pitch = begin + i >= samples.size() ? 1 : 0;
    const Sample& last = samples[(begin + i - 1) % samples.size()];
    const Sample& next = samples[(begin + i) % samples.size()];
    const int last_pitch = begin + i - 1 >= samples.size() ? 1 : 0;
    if (last.touched && !next.touched) {
      before_shadow = ball.last_touched(last, next);
      add(before_shadow.place(), last_pitch);
      closing.shadows.push_back({before_shadow.arc_length() + last_pitch * length, 0.0});
    } else if (!last.touched && next.touched) {
      const Sample after = ball.last_touched(next, last);
      const auto here = [&](const Eigen::Vector2d& point, bool beyond) -> Eigen::Vector2d {
        return beyond ? shifted_by_pitches(profile.sector, point, 1) : point;
      };
      const bool from_beyond = closing.shadows.back().from >= length;
      const Eigen::Vector2d from = here(before_shadow.place(), from_beyond);
      const Eigen::Vector2d to = here(after.place(), pitch == 1);
      const Eigen::Vector2d centre = 0.5 * (here(ball.centre(before_shadow), from_beyond) +
                                            here(ball.centre(after), pitch == 1));
      const double arc_from = way;
      for (const auto& node : arc_between(from, to, centre)) add(node, 0);
      add(to, 0);
      closing.arcs.push_back({arc_from, way});
      closing.shadows.back().to = after.arc_length() + pitch * length;
    }
    if (next.touched) add(next.place(), pitch);
  }
  for (Shadow& shadow : closing.shadows) {
    if (shadow.from < length) continue;
    shadow.from -= length;
    shadow.to -= length;
  }
  std::sort(closing.shadows.begin(), closing.shadows.end(),
            [](const Shadow& a, const Shadow& b) { return a.from < b.from; });
  return closing;
}

}  // namespace millwear::wear
