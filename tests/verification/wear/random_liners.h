#pragma once
#include <Eigen/Core>

#include "mill/liner/liner_profile.h"
#include "wear/evolve/profile_motion.h"
#include "wear/numerics/arc_curve.h"

namespace millwear::wear {

/// A whole number in [low, high) times `unit`, drawn by rapidcheck.
[[nodiscard]] double between(int low, int high, double unit);

/// A liner of 4 to 40 rows, 0.2 to 6 m in radius. Its shape is one of: a trapezoid with or without
/// a nose, one with a tall thin fin, a wavy plate, a cap on a narrower stem, a lifter that leans
/// over its leading face, two lifters a pitch. Above every place of the mill's circumference lies
/// one surface, but for the cap and the leaning lifter.
[[nodiscard]] LinerProfile random_liner();

/// The same, of the shapes above every place of whose circumference lies one surface only.
[[nodiscard]] LinerProfile random_upright_liner();

/// Rates of wear of the size 1 over `bins` bins: noise with an unloaded stretch, one bin alone, a
/// narrow peak on a low level, one part of the pitch only, or a few strong spots.
[[nodiscard]] ArcCurve random_load(const LinerProfile& profile, Eigen::Index bins);

/// Wears `area` [m2] off by a load.
[[nodiscard]] MovedProfile worn_by(const LinerProfile& profile, const ArcCurve& load, double area);

/// Area that `after` covers and `before` does not [m2].
[[nodiscard]] double gained(const LinerProfile& before, const LinerProfile& after);

/// Greatest distance of a node of either profile from the other [m], images on the neighbouring
/// pitches counted.
[[nodiscard]] double distance_between(const LinerProfile& first, const LinerProfile& second);

/// The same steel with the sector's edges at node `start` of the profile.
[[nodiscard]] LinerProfile started_at(const LinerProfile& profile, std::size_t start);

}  // namespace millwear::wear
