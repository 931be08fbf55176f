#include "orchestrator/study/derived_axes.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/case_file/case_edit.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/study/study_values.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double circumference(const Case& mill) {
  return 2.0 * std::numbers::pi * mill.liner.sector.plate_radius;
}

double number_above_zero(std::string_view axis, const CaseValue& value) {
  const double number = number_of(value).value_or(0.0);
  if (number > 0.0 && std::isfinite(number)) return number;
  throw InputError(fmt::format("a value of `{}` is no number above zero", axis));
}

double lifter_number(const CaseDocument& document, std::string_view key) {
  const CaseTable* const lifter = document.find("lifter");
  const CaseValue* const value = lifter != nullptr ? lifter->find(key) : nullptr;
  const double number = value != nullptr ? number_of(*value).value_or(nan) : nan;
  if (std::isnan(number))
    throw InputError(
        fmt::format("the lifter has no `{}`: it is given by its profile, not by "
                    "height, width and face angles; vary `mill.rows` or `spacing_m`",
                    key));
  return number;
}

/// Width of a lifter where it stands on the plate.
double foot_width(const CaseDocument& document) {
  const double height = lifter_number(document, "height_m");
  const auto beside = [&](std::string_view angle) {
    return height * std::tan(lifter_number(document, angle) * radians_per_degree);
  };
  return lifter_number(document, "top_width_m") + beside("leading_face_angle_deg") +
         beside("trailing_face_angle_deg");
}

CaseDocument with_spacing(const CaseDocument& document, const Case& mill, double spacing,
                          int line) {
  const auto rows = std::llround(circumference(mill) / spacing);
  return with_value(document, {"mill", "", "rows"}, {line, std::int64_t{rows}});
}

}  // namespace

bool is_derived_axis(std::string_view key) {
  return key == spacing_axis || key == plate_width_axis || key == spacing_to_height_axis;
}

double lifter_spacing(const Case& mill) { return circumference(mill) / mill.liner.sector.rows; }

CaseDocument with_derived(const CaseDocument& document, std::string_view axis,
                          const CaseValue& value, DerivedChoice choice) {
  const Case mill = case_from_document(document, read_drawn_liner);
  const double number = number_above_zero(axis, value);
  if (axis == spacing_axis) return with_spacing(document, mill, number, value.line);
  if (axis == plate_width_axis)
    return with_spacing(document, mill, number + foot_width(document), value.line);
  if (choice == DerivedChoice::rows)
    return with_spacing(document, mill, number * lifter_height(mill.liner), value.line);
  static_cast<void>(lifter_number(document, "height_m"));
  return with_value(document, {"lifter", "", "height_m"},
                    {value.line, lifter_spacing(mill) / number});
}

}  // namespace millwear::orchestrator
