#include "wear/gauge/alignment_fit.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/signed_surface.h"

namespace millwear::wear {
namespace {

constexpr int places_along = 400;
constexpr int places_in_search = 64;
constexpr int turns = 36;
constexpr int shifts_along = 16;
constexpr int shifts_up = 3;
constexpr int starts_refined = 40;
/// While the scale is wide, steel that would stand out of the reference weighs more.
constexpr double most_weight = 9.0;
constexpr double wide_of_lifter = 0.1;
constexpr double hop_scales_of_lifter[] = {0.05, 0.0};
constexpr std::size_t poses_hopped = 4;
constexpr std::size_t poses_kept = 6;
constexpr double hop_turn = 0.035;      // [rad]
constexpr double hop_of_lifter = 0.12;  // of its size
constexpr double worn_below = 3.0;
constexpr double stands_out_above = 10.0;
constexpr double shrink = 0.7;
constexpr int steps_per_scale = 4;
constexpr int last_steps = 40;
constexpr double least_scatter_of_error = 0.02;
constexpr double least_used_share = 0.3;
constexpr double most_scatter_of_error = 1.5;
constexpr double least_hold = 0.05;
constexpr double stands_out_over_error = 3.0;
constexpr double most_standing_out = 0.05;
constexpr double nearly_as_good = 0.95;
constexpr double mirrored_better = 0.99;

struct Pose {
  RigidMotion motion;
  double cost;  ///< mean of rho, 0 ... 100
};

/// What a pose is better than one in which every place lies deep in the steel.
double gain(const Pose& pose) { return worn_below * worn_below - pose.cost; }

bool is_used(double height, double scale) {
  return height > -worn_below * scale && height < stands_out_above * scale;
}

double rho(double height, double scale) {
  const double u = height / scale;
  if (u <= -worn_below) return worn_below * worn_below;
  return u < stands_out_above ? u * u : stands_out_above * stands_out_above;
}

class Fit {
 public:
  Fit(const LinerProfile& reference, const Curve& curve, double error)
      : reference_(reference),
        curve_(curve),
        error_(error),
        surface_(reference, 0.5 * reference_length(reference)),
        places_(even_places({reference.sector, curve}, places_along)),
        few_places_(even_places({reference.sector, curve}, places_in_search)) {}

  /// The best poses at different places, the best first.
  [[nodiscard]] std::vector<Pose> best_poses() const {
    std::vector<Pose> best = best_apart(starts(), scale_of_lifter(wide_of_lifter));
    std::vector<Pose> found = best;
    for (const double share : hop_scales_of_lifter) {
      std::vector<Pose> hops;
      for (std::size_t i = 0; i < std::min(poses_hopped, best.size()); ++i)
        for (const Pose& hop : hops_from(best[i])) hops.push_back(hop);
      for (const Pose& pose : best_apart(std::move(hops), scale_of_lifter(share)))
        found.push_back(pose);
    }
    best = apart(std::move(found));
    for (Pose& pose : best) pose = polished(pose);
    return apart(std::move(best));
  }

  [[nodiscard]] FitQuality quality(const Pose& pose) const {
    const double scale = scatter(pose.motion);
    double sum = 0.0;
    std::vector<Eigen::Vector3d> rows;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    std::vector<SurfacePlace> used;
    Curve points;
    int standing_out = 0;
    for (const auto& place : places_) {
      const Eigen::Vector2d point = pose.motion(place);
      const auto on = surface_.place(point);
      if (on.height > stands_out_over_error * error_) ++standing_out;
      if (!is_used(on.height, scale)) continue;
      sum += on.height * on.height;
      centre += point;
      used.push_back(on);
      points.push_back(point);
    }
    const auto count = static_cast<double>(used.size());
    if (used.empty()) return {std::numeric_limits<double>::infinity(), 0.0, 0.0, 1.0};
    centre /= count;
    double lever = 0.0;
    for (const auto& point : points) lever += (point - centre).squaredNorm() / count;
    lever = std::sqrt(lever);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Eigen::Vector3d row = gradient(used[i], points[i] - centre, lever);
      normal += row * row.transpose() / count;
    }
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()[0];
    return {std::sqrt(sum / count), count / places_along, std::sqrt(std::max(least, 0.0)),
            static_cast<double>(standing_out) / places_along};
  }

  [[nodiscard]] AlignedCurve aligned(const Pose& pose) const {
    const auto& sector = reference_.sector;
    AlignedCurve result{{}, pose.motion, false};
    for (const auto& node : curve_) result.nodes.push_back(pose.motion(node));
    if (angle_of(sector, result.nodes.front()) > angle_of(sector, result.nodes.back())) {
      std::reverse(result.nodes.begin(), result.nodes.end());
      result.reversed = true;
    }
    return result;
  }

 private:
  static double reference_length(const LinerProfile& reference) {
    return reference.sector.pitch() * reference.sector.plate_radius;
  }

  static std::vector<Pose> by_cost(std::vector<Pose> poses) {
    std::stable_sort(poses.begin(), poses.end(),
                     [](const Pose& a, const Pose& b) { return a.cost < b.cost; });
    return poses;
  }

  [[nodiscard]] std::vector<Pose> apart(std::vector<Pose> poses) const {
    std::vector<Pose> different;
    for (const Pose& pose : by_cost(std::move(poses)))
      if (different.size() < poses_kept && is_elsewhere(pose, different)) different.push_back(pose);
    return different;
  }

  [[nodiscard]] std::vector<Pose> best_apart(std::vector<Pose> from, double scale) const {
    for (Pose& pose : from) pose = refined(pose, scale);
    return apart(std::move(from));
  }

  /// Poses near one, from which a better one may be found: a search on few starts stops at places
  /// where much of the curve lies on the reference by chance.
  [[nodiscard]] std::vector<Pose> hops_from(const Pose& pose) const {
    const double far = hop_of_lifter * lifter_size();
    const Eigen::Vector2d middle = pose.motion(few_places_[few_places_.size() / 2]);
    std::vector<Pose> hops;
    for (const double turn : {-2.0 * hop_turn, -hop_turn, 0.0, hop_turn, 2.0 * hop_turn}) {
      const RigidMotion turned{turn, Eigen::Vector2d::Zero()};
      const Eigen::Vector2d shift = middle + turned(pose.motion.shift - middle);
      for (const double along : {-far, 0.0, far}) {
        for (const double up : {-far, 0.0, far}) {
          const Eigen::Vector2d hop(along, up);
          hops.push_back({{pose.motion.angle + turn, shift + hop}, 0.0});
        }
      }
    }
    return hops;
  }

  /// How the height changes as the curve turns about a place (by an angle times `lever`) and moves.
  static Eigen::Vector3d gradient(const SurfacePlace& on, const Eigen::Vector2d& arm,
                                  double lever) {
    const double turning = arm.x() * on.outward.y() - arm.y() * on.outward.x();
    return {turning / lever, on.outward.x(), on.outward.y()};
  }

  /// Height of the lifter over its feet: the size of what is to be matched.
  [[nodiscard]] double lifter_size() const {
    const auto& nodes = reference_.nodes;
    const double edge = radius_of(reference_.sector, nodes.front());
    return std::max(edge - crest_radius(reference_), 10.0 * error_);
  }

  [[nodiscard]] double scale_of_lifter(double share) const {
    return std::max(2.0 * error_, share * lifter_size());
  }

  [[nodiscard]] double cost_of(const RigidMotion& motion, const Curve& places, double scale) const {
    double sum = 0.0;
    for (const auto& place : places) sum += rho(surface_.place(motion(place)).height, scale);
    return sum / static_cast<double>(places.size());
  }

  [[nodiscard]] std::vector<Pose> starts() const {
    const Curve reference_places = even_places(reference_, places_in_search);
    const auto mean = [](const Curve& places) {
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const auto& place : places) sum += place;
      return Eigen::Vector2d(sum / static_cast<double>(places.size()));
    };
    const Eigen::Vector2d target = mean(reference_places);
    const Eigen::Vector2d source = mean(few_places_);
    const double along = reference_length(reference_) / shifts_along;
    const double up = lifter_size() / shifts_up;
    std::vector<Pose> poses;
    for (int turn = 0; turn < turns; ++turn) {
      const RigidMotion turned{2.0 * std::numbers::pi * turn / turns, Eigen::Vector2d::Zero()};
      const Eigen::Vector2d centred = target - turned(source);
      for (int i = -shifts_along / 2; i <= shifts_along / 2; ++i) {
        for (int j = -shifts_up; j <= shifts_up; ++j) {
          const RigidMotion motion{turned.angle, centred + Eigen::Vector2d(i * along, j * up)};
          poses.push_back({motion, cost_of(motion, few_places_, scale_of_lifter(wide_of_lifter))});
        }
      }
    }
    poses = by_cost(std::move(poses));
    poses.resize(starts_refined);
    return poses;
  }

  /// One Gauss-Newton step on the places that are used.
  [[nodiscard]] RigidMotion step(const RigidMotion& motion, const Curve& places,
                                 double scale) const {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    const Eigen::Vector2d centre = motion(places[places.size() / 2]);
    const double lever = 0.25 * reference_length(reference_);
    for (const auto& place : places) {
      const Eigen::Vector2d point = motion(place);
      const auto on = surface_.place(point);
      if (!is_used(on.height, scale)) continue;
      const Eigen::Vector3d row = gradient(on, point - centre, lever);
      const double weight = on.height > 0.0 ? std::clamp(scale / error_, 1.0, most_weight) : 1.0;
      normal += weight * row * row.transpose();
      right -= weight * row * on.height;
    }
    if (!(normal.trace() > 0.0)) return motion;
    normal.diagonal().array() += 1e-9 * normal.trace();
    const Eigen::Vector3d change = normal.ldlt().solve(right);
    const RigidMotion turn{change[0] / lever, Eigen::Vector2d::Zero()};
    const Eigen::Vector2d shift = centre + change.tail<2>() + turn(motion.shift - centre);
    return {motion.angle + turn.angle, shift};
  }

  [[nodiscard]] Pose refined(Pose pose, double scale) const {
    for (;; scale = std::max(shrink * scale, error_)) {
      for (int i = 0; i < steps_per_scale; ++i) pose.motion = step(pose.motion, few_places_, scale);
      if (scale <= error_) break;
    }
    pose.cost = cost_of(pose.motion, few_places_, error_);
    return pose;
  }

  /// Root mean square of the heights above the reference: the scatter that no wear disturbs.
  [[nodiscard]] double scatter(const RigidMotion& motion) const {
    double sum = 0.0;
    int count = 0;
    for (const auto& place : places_) {
      const double height = surface_.place(motion(place)).height;
      if (height <= 0.0 || height >= stands_out_above * error_) continue;
      sum += height * height;
      ++count;
    }
    const double found = count > 0 ? std::sqrt(sum / count) : 0.0;
    return std::clamp(found, least_scatter_of_error * error_, error_);
  }

  [[nodiscard]] Pose polished(Pose pose) const {
    for (int i = 0; i < steps_per_scale; ++i) pose.motion = step(pose.motion, places_, error_);
    double scale = error_;
    for (int i = 0; i < last_steps; ++i) {
      scale = std::max(shrink * scale, scatter(pose.motion));
      pose.motion = step(pose.motion, places_, scale);
    }
    pose.motion = on_own_pitch(pose.motion);
    pose.cost = cost_of(pose.motion, places_, error_);
    return pose;
  }

  /// The same pose on the pitch of the master lifter.
  [[nodiscard]] RigidMotion on_own_pitch(const RigidMotion& motion) const {
    const auto& sector = reference_.sector;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const auto& place : few_places_) middle += motion(place) / places_in_search;
    const int pitches = static_cast<int>(std::lround(angle_of(sector, middle) / sector.pitch()));
    const Eigen::Vector2d shift = shifted_by_pitches(sector, motion.shift, -pitches);
    const Eigen::Vector2d unit = shifted_by_pitches(
        sector, motion.shift + Eigen::Vector2d(std::cos(motion.angle), std::sin(motion.angle)),
        -pitches);
    return {std::atan2(unit.y() - shift.y(), unit.x() - shift.x()), shift};
  }

  [[nodiscard]] bool is_elsewhere(const Pose& pose, const std::vector<Pose>& others) const {
    const double apart = 5.0 * error_;
    return std::none_of(others.begin(), others.end(), [&](const Pose& other) {
      for (const int pitch : {-1, 0, 1}) {
        double farthest = 0.0;
        for (const auto& place : few_places_)
          farthest =
              std::max(farthest, (shifted_by_pitches(reference_.sector, pose.motion(place), pitch) -
                                  other.motion(place))
                                     .norm());
        if (farthest < apart) return true;
      }
      return false;
    });
  }

  const LinerProfile& reference_;
  const Curve& curve_;
  double error_;
  SignedSurface surface_;
  Curve places_;
  Curve few_places_;
};

void check_quality(const FitQuality& quality, double error) {
  if (quality.used_share < least_used_share)
    throw InputError(fmt::format(
        "the curve does not fit the reference: {:.0f} % of it lies on its surface, {:.0f} % would "
        "do; look at its units, give a reference that is worn like it, or align it by its ends",
        100.0 * quality.used_share, 100.0 * least_used_share));
  if (quality.rms > most_scatter_of_error * error)
    throw InputError(
        fmt::format("the curve lies {:.2f} mm (rms) from the reference where it fits best, and its "
                    "error is said "
                    "to be {:.2f} mm; if all of it is worn, align it by its ends or on an earlier "
                    "profile, else "
                    "give the error that it has",
                    1e3 * quality.rms, 1e3 * error));
  if (quality.standing_out > most_standing_out)
    throw InputError(fmt::format(
        "where the curve fits best, {:.0f} % of it stands out of the reference by more than three "
        "errors; if all of it is worn, align it by its ends or on an earlier profile",
        100.0 * quality.standing_out));
  if (quality.hold < least_hold)
    throw InputError(fmt::format(
        "the fit is ambiguous: what is unworn of the curve ({:.0f} % of it) lets it slide along "
        "the "
        "reference, as a plate alone does; give a reference that is worn like it, or align it by "
        "its ends",
        100.0 * quality.used_share));
}

}  // namespace

FittedCurve aligned_by_fit(const LinerProfile& reference, const Curve& curve, double error) {
  if (curve.size() < 3) throw InputError("a curve of fewer than three nodes has no shape to align");
  const Fit fit(reference, curve, error);
  const auto poses = fit.best_poses();
  const Curve other_side = mirror_image(curve);
  const auto mirrored = Fit(reference, other_side, error).best_poses();
  if (gain(poses.front()) < mirrored_better * gain(mirrored.front()))
    throw InputError(
        "the curve's mirror image fits the reference better: it was seen from the other end of the "
        "mill; mirror it (or leave it as it is where it was mirrored)");
  const FitQuality quality = fit.quality(poses.front());
  check_quality(quality, error);
  if (poses.size() > 1 && gain(poses[1]) >= nearly_as_good * gain(poses[0]))
    throw InputError(
        "the fit is ambiguous: the curve lies on the reference nearly as well at another place; "
        "give a longer curve, a reference that is worn like it, or align it by its ends");
  return {fit.aligned(poses.front()), quality};
}

}  // namespace millwear::wear
