#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// Which way the mill turns: as when its liner was new, or the other way.
enum class Rotation { as_new, reversed };

/// As the case file writes it.
[[nodiscard]] std::string_view name_of(Rotation rotation);

/// How often the mill was reversed by a time of milling [s], given the times of its reversals,
/// increasing. One less than a second ahead counts, so that the sum of the steps that led to it
/// need not meet it to the last bit.
[[nodiscard]] int reversals_by(std::span<const double> reversal_times, double time);

/// Which way the mill turns after a time of milling [s]: as new after an even number of reversals.
[[nodiscard]] Rotation rotation_after(std::span<const double> reversal_times, double time);

/// Milling left until the next reversal [s], at least a second; std::nullopt if none comes.
[[nodiscard]] std::optional<double> time_to_reversal(std::span<const double> reversal_times,
                                                     double time);

/// From the steel's frame to the DEM's and back. The DEM's mill always turns along the direction of
/// xi, so it holds the mirror image of a liner whose mill is reversed. Each `as_turned` leaves what
/// it is given where the mill turns as when new, and is its own inverse.

/// A point of the master frame [m].
[[nodiscard]] Eigen::Vector2d as_turned(const Eigen::Vector2d& point, Rotation rotation);

[[nodiscard]] LinerProfile as_turned(const LinerProfile& liner, Rotation rotation);

/// Values at the nodes of a profile, in the profile's order.
[[nodiscard]] std::vector<double> as_turned(const std::vector<double>& at_nodes, Rotation rotation);

/// Values of even bins along a profile, one quantity a column.
[[nodiscard]] Eigen::MatrixXd by_bin_as_turned(const Eigen::MatrixXd& by_bin, Rotation rotation);

}  // namespace millwear
