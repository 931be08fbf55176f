#pragma once
#include <Eigen/Core>

namespace millwear::wear {

/// Degrees of the histogram around the mill.
inline constexpr Eigen::Index degrees_around = 360;

/// Where around the (non-rotating) mill the charge touches the liner: one row a degree of the angle
/// from six o'clock along the rotation, from -180 to 180, one column a time block.
struct ChargeAngles {
  Eigen::MatrixXd contacts;      ///< wall contacts seen in samples [-], 360 x blocks
  Eigen::MatrixXd normal_force;  ///< sum of their normal forces [N], 360 x blocks
};

[[nodiscard]] ChargeAngles no_charge_angles(std::size_t block_count);

/// The same with time blocks added at the end, in which nothing touched yet.
[[nodiscard]] ChargeAngles with_blocks(const ChargeAngles& angles, std::size_t block_count);

/// Row of the histogram of an angle from six o'clock [rad], -pi ... pi.
[[nodiscard]] Eigen::Index degree_around(double angle_from_six);

/// Counts one contact at an angle from six o'clock [rad], -pi ... pi, with its force [N].
void add_contact(ChargeAngles& angles, double angle_from_six, double normal_force,
                 std::size_t block);

/// Toe and shoulder of the charge [rad] as Morrell reports them: from three o'clock on the rising
/// side, along the mill's rotation, 0 ... 2 pi. Six o'clock is 3 pi/2; shoulders stand near 40 to
/// 60 degrees, toes near 210 to 230. The errors are standard errors from the time blocks. Not a
/// number: all four where the charge goes all the way around (it centrifuges), the errors where
/// fewer than two blocks have a toe and a shoulder.
struct ChargePosition {
  double toe;
  double toe_error;
  double shoulder;
  double shoulder_error;
};

/// Toe and shoulder from the wall contacts. The number of contacts per degree is averaged over
/// five degrees; the charge lies on the arc around its maximum where that stays above a tenth of
/// its own 90th percentile (over the degrees that were touched at all), and toe and shoulder are
/// where it falls through that level, to a fraction of a degree. Particles in flight that touch the
/// liner elsewhere are far below that level.
/// Throws ResultRejected where nothing touches the liner.
[[nodiscard]] ChargePosition charge_position(const ChargeAngles& angles);

}  // namespace millwear::wear
