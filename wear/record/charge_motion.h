#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>

#include "mill/liner/liner_profile.h"
#include "wear/record/charge_position.h"

namespace millwear::wear {

/// Parts of the charge, by how they move. docs/physics.md says why these.
enum class ChargePart {
  all,
  airborne,        ///< in free flight: nothing touches it
  ascending,       ///< not airborne, with v . (Omega x x) > 0
  locked,          ///< ... of it what moves with the mill: |v - Omega x x| < `locked_slip` omega R
  between,         ///< ascending, and its centre farther from the axis than the lifters' crests
  between_locked,  ///< both
};
inline constexpr std::size_t charge_part_count = 6;
inline constexpr std::array<std::string_view, charge_part_count> charge_part_names = {
    "all", "airborne", "ascending", "locked", "between", "between_locked"};

/// Largest speed against the turning mill, as a share of the plate's, of what counts as moving with
/// it.
inline constexpr double locked_slip = 0.05;

/// Least normal speed of a hit on the bare liner [m/s].
inline constexpr double bare_hit_speed = 0.5;

/// Share of the lift, from the liner's lowest place, up to which a hit is one on the plate.
inline constexpr double plate_share_of_lift = 0.2;

/// The turning mill as a particle of its charge sees it: about +y, with `speed`.
struct TurningMill {
  double speed;         ///< omega [rad/s]
  double plate_radius;  ///< R, on the new plate [m]
  double crest_radius;  ///< of the circle through the lifters' crests [m]
};

enum class Flight { touching, airborne };

/// One particle at one instant.
struct ParticleMotion {
  Eigen::Vector3d place;     ///< of its centre [m], mill frame
  Eigen::Vector3d velocity;  ///< [m/s]
  double mass;               ///< [kg]
  Flight flight;
};

/// Mass of every part of the charge at one instant [kg], in the order of `ChargePart`.
using Census = Eigen::Array<double, static_cast<int>(charge_part_count), 1>;

/// Counts one particle to all parts it belongs to.
void count(Census& census, const TurningMill& mill, const ParticleMotion& particle);

/// Hits on the bare liner from flight, by the degree around the mill as in `ChargeAngles` and by
/// time block.
struct BareHits {
  Eigen::MatrixXd mass;    ///< of the particles, summed over hits [kg], 360 x blocks
  Eigen::MatrixXd energy;  ///< m v^2 / 2, v against the liner [J], 360 x blocks
};

/// How the charge moved in one measurement.
struct ChargeMotion {
  Eigen::MatrixXd census;  ///< sum over the samples [kg], charge_part_count x blocks
  BareHits plate;          ///< hits up to `plate_share_of_lift` above the liner's lowest place
  BareHits lifter;         ///< hits above
};

[[nodiscard]] ChargeMotion no_charge_motion(std::size_t block_count);

/// The same with time blocks added at the end, in which nothing was seen yet.
[[nodiscard]] ChargeMotion with_blocks(const ChargeMotion& motion, std::size_t block_count);

/// Counts one hit at an angle from six o'clock [rad], -pi ... pi.
void add_hit(BareHits& hits, double angle_from_six, double mass, double energy, std::size_t block);

void add_motion(ChargeMotion& sum, const ChargeMotion& more);

/// Least distance from the axis [m] of what counts as the plate; all of the liner where it has no
/// lifters higher than `tolerance` [m].
[[nodiscard]] double plate_limit_radius(const LinerProfile& profile, double tolerance);

/// A mean over the time blocks and its standard error. NaN where it is not known.
struct Estimate {
  double value;
  double error;
};

/// What is told of the motion. Each is a ratio of sums over the measurement; its standard error is
/// that of a ratio, from the time blocks. NaN where the whole that a share is of has no mass, and
/// everything where the motion was not recorded.
struct MotionMeasures {
  Estimate airborne_share;        ///< of the charge's mass
  Estimate dead_zone_share;       ///< locked, of the ascending charge
  Estimate between_locked_share;  ///< locked, of the ascending charge between the lifters
  Estimate packed_share;          ///< locked between the lifters, of the whole ascending charge
  Estimate bare_hit_mass_share;   ///< mass that hits a revolution, of the charge's mass
  Estimate bare_hit_power;        ///< [W]
  Estimate
      bare_hit_falling_power;     ///< of it between twelve and six o'clock, where charge falls [W]
  Estimate bare_hit_plate_power;  ///< of it on the plate [W]
};

[[nodiscard]] MotionMeasures unknown_motion();

/// What a measurement was made on.
struct MotionScale {
  double duration;     ///< [s]
  double speed;        ///< of the mill [rad/s]
  double charge_mass;  ///< [kg]
};

[[nodiscard]] MotionMeasures motion_measures(const ChargeMotion& motion, const MotionScale& scale);

}  // namespace millwear::wear
