#pragma once
#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// Least slice length in diameters of the largest particle. Two or more are advised; the published
/// 8 m mill runs 180 mm rocks in 0.25 m (1.39 diameters), so less than 1.1 is refused.
inline constexpr double least_slice_diameters = 1.1;
inline constexpr double advised_slice_diameters = 2.0;

/// Most of the inside volume that a charge at rest may take, voids included.
inline constexpr double most_filling = 0.9;
/// Random close packing of equal spheres: no charge at rest is denser for long.
inline constexpr double random_packing = 0.64;
/// A time step above this share of the least Rayleigh time is unstable in dense charges.
inline constexpr double stable_rayleigh_share = 0.5;
/// LIGGGHTS refuses a Young's modulus under this [Pa].
inline constexpr double least_young_modulus = 5e6;
/// Time blocks from which a standard error is good enough to end a measurement by.
inline constexpr int least_blocks_for_a_target = 5;
/// Most nodes of a profile: its locked copy has to stay under the size limit of a case file.
inline constexpr std::size_t most_profile_nodes = 1000;

/// What a mill cannot be, over and above single keys: profile, charge, materials, time step,
/// target of a measurement, limits.
void check_case(const Case& mill, const CaseDocument& document, CaseProblems& problems);

}  // namespace millwear
