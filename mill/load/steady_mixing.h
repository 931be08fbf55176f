#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mill/case/case.h"
#include "mill/case/time_step.h"

namespace millwear {

/// How a mixing stretch that ends once it is steady is cut. Every length is in steps and a whole
/// number of pieces, a piece a whole number of pitches.
struct MixingPlan {
  long piece;       ///< torque and kinetic energy are averaged over each
  long left_out;    ///< at the beginning, while the charge falls
  long most;        ///< it ends then, steady or not
  long revolution;  ///< steps of one
  bool operator==(const MixingPlan&) const = default;
};

/// Pieces of the window whose mean is compared with that of the window before.
inline constexpr int pieces_of_window = 4;

/// A piece is the fewest pitches that are a thirty-second of a revolution or more, and a quarter of
/// a revolution is left out. `most` is `dem.mix_revolutions`, rounded up to whole pieces.
[[nodiscard]] MixingPlan mixing_plan(const Case& mill, const StepPlan& plan);

/// The first step at which a mixing can be steady: two windows behind what is left out.
[[nodiscard]] long least_steps(const MixingPlan& plan);

/// Means over one piece.
struct MixedPiece {
  double torque;          ///< of the particles on the liner about +y [N m]
  double kinetic_energy;  ///< of the particles' motion, without spin [J]
  /// How many particles of each class (diameter and material) touch the liner, the largest first;
  /// empty where nobody counts.
  std::vector<double> on_liner{};
  bool operator==(const MixedPiece&) const = default;
};

/// How far a quantity drifts over two windows, as shares of its mean.
struct Drift {
  double relative;  ///< >= 0; not finite where the mean is zero
  double limit;     ///< it is steady up to this
};

[[nodiscard]] bool is_steady(const Drift& drift);

/// The drift of the `2 * pieces_of_window` last values of `series`. With h_1 ... h_4 the means of
/// the half windows and m the mean of all,
///     relative = max(|h_3 + h_4 - h_1 - h_2|, |h_1 + h_4 - h_2 - h_3|, |h_1 + h_3 - h_2 - h_4|)
///                / (2 |m|):
/// a slope, a turning point, and a swing that takes a whole window each count alike. Each of the
/// three is a difference between two means of n = `pieces_of_window` pieces, of the standard error
/// s sqrt(2 / n), s^2 from the differences between the two pieces of each half window. The limit is
/// twice that, within 5 % ... 15 % of the mean. Throws std::invalid_argument for a shorter series.
[[nodiscard]] Drift drift_of(std::span<const double> series);

/// How far a class's share of the particles on the liner drifts.
struct ClassDrift {
  std::size_t particle_class;  ///< index into `MixedPiece::on_liner`
  Drift share;
};

/// The class whose share of the particles on the liner is furthest above its limit, or nearest to
/// it. Segregation is slow, and the slower the longer it has gone on. So the windows grow: with n
/// pieces behind what is left out they are the last n / 4 and the n / 4 before, at least
/// `pieces_of_window` each. With p the share in both and p1, p2 that of each, the drift is
/// |p2 - p1| / p. Its limit is 5 %, or 2.5 standard errors where these are more:
///     error^2 = p (1 - p) (1 / (N1 q) + 1 / (N2 q)) / p^2,
/// N1 and N2 the particles on the liner, and q the quarters of a revolution in a window, at least
/// one, because a particle stays on the liner for about so long. None with fewer than two classes.
[[nodiscard]] std::optional<ClassDrift> class_drift(const MixingPlan& plan,
                                                    std::span<const MixedPiece> pieces);

struct MixingDrift {
  Drift torque;
  Drift kinetic_energy;
  std::optional<ClassDrift> on_liner{};
};

/// The drift after all `pieces` so far; none while two windows behind what is left out are not
/// full.
[[nodiscard]] std::optional<MixingDrift> mixing_drift(const MixingPlan& plan,
                                                      std::span<const MixedPiece> pieces);

enum class MixingState {
  drifts,   ///< it has to go on
  steady,   ///< torque, kinetic energy and the classes on the liner
  at_most,  ///< it ends without being steady
};

[[nodiscard]] MixingState mixing_state(const MixingPlan& plan, std::span<const MixedPiece> pieces);

}  // namespace millwear
