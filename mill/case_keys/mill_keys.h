#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/key_row.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear {

/// The version of the case file format that this program reads and writes.
inline constexpr int case_format_version = 1;

/// The keys before the first table.
[[nodiscard]] const std::vector<KeyRow<Case>>& top_keys();

/// The keys of [mill]; `critical_speed_fraction` is left to the builder.
[[nodiscard]] const std::vector<KeyRow<Case>>& mill_keys();

/// The keys of [lifter] that every form of a lifter has, to be read after those of [mill];
/// `material` is left to the builder.
[[nodiscard]] const std::vector<KeyRow<Case>>& lifter_keys();

/// The keys of [lifter] of which a parametric one takes all.
[[nodiscard]] const std::vector<KeyRow<ParametricLifter>>& lifter_shape_keys();

/// The radii of such a lifter, which it may have.
[[nodiscard]] const std::vector<KeyRow<ParametricLifter>>& lifter_radius_keys();

/// The other keys of [lifter], all left to the builder.
[[nodiscard]] const std::vector<KeyRow<LinerProfile>>& lifter_profile_keys();

}  // namespace millwear
