#pragma once
#include <Eigen/Core>
#include <vector>

#include "mill/liner/liner_profile.h"

namespace millwear::meshgen {

/// The outline of the DEM mesh over one pitch: the fewest of the profile's nodes whose chords stay
/// within `tolerance` [m] of the profile, and the profile within `tolerance` of them. Both ends
/// are kept. Of all outlines with that few facets it takes the one that deviates least,
///     min sum over the facets of max(2 protrusion, recession)^2,
/// so that corners stay where they cost nothing, arcs are cut evenly, and a facet rather cuts into
/// steel (recession) than stands out into the charge (protrusion). Standing out by up to the
/// tolerance cannot be avoided where the plate is hollow: particles at rest on the mesh before it
/// may overlap a new one by that much.
/// The profile has 3 nodes or more and the tolerance is positive (std::logic_error). Throws
/// InputError if the profile or its outline crosses itself or has a node twice.
[[nodiscard]] std::vector<Eigen::Vector2d> dem_outline(const LinerProfile& profile,
                                                       double tolerance);

/// `outline` with every facet longer than `longest` [m] cut into equal parts.
[[nodiscard]] std::vector<Eigen::Vector2d> with_facets_below(
    const std::vector<Eigen::Vector2d>& outline, double longest);

/// Lengths of the facets [m], one fewer than nodes.
[[nodiscard]] std::vector<double> facet_lengths(const std::vector<Eigen::Vector2d>& outline);

}  // namespace millwear::meshgen
