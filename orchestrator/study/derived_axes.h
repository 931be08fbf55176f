#pragma once
#include <string>
#include <string_view>

#include "mill/case/case.h"
#include "mill/case_keys/case_document.h"

namespace millwear::orchestrator {

/// Axes that are no keys of a case but follow from rows and height of the lifters.
inline constexpr std::string_view spacing_axis = "spacing_m";
inline constexpr std::string_view plate_width_axis = "plate_width_m";
inline constexpr std::string_view spacing_to_height_axis = "spacing_to_height";

[[nodiscard]] bool is_derived_axis(std::string_view key);

/// Distance from lifter to lifter along the new plate, 2 pi R / rows [m].
[[nodiscard]] double lifter_spacing(const Case& mill);

/// What a derived axis may choose.
enum class DerivedChoice { rows, height };

/// The document with a derived axis at a value. `spacing_m`: as many rows as come nearest to it.
/// `plate_width_m`: likewise the width of plate between the feet of two lifters, of a lifter that
/// is given by width and face angles. `spacing_to_height`: rows, or with `choice` height the
/// lifter's height. Throws InputError where the value is no number above zero, or the lifter has
/// not what it takes.
[[nodiscard]] CaseDocument with_derived(const CaseDocument& document, std::string_view axis,
                                        const CaseValue& value, DerivedChoice choice);

}  // namespace millwear::orchestrator
