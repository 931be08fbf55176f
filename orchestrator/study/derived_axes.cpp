#include "orchestrator/study/derived_axes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/case_file/case_edit.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"

namespace millwear::orchestrator {
namespace {

double circumference(const Case& mill) {
  return 2.0 * std::numbers::pi * mill.liner.sector.plate_radius;
}

double number_above_zero(std::string_view axis, const CaseValue& value) {
  double number = 0.0;
  if (const auto* const real = std::get_if<double>(&value.data)) number = *real;
  if (const auto* const whole = std::get_if<std::int64_t>(&value.data))
    number = static_cast<double>(*whole);
  if (number > 0.0 && std::isfinite(number)) return number;
  throw InputError(fmt::format("a value of `{}` is no number above zero", axis));
}

double lifter_number(const CaseDocument& document, std::string_view key) {
  const CaseTable* const lifter = document.find("lifter");
  const CaseValue* const value = lifter != nullptr ? lifter->find(key) : nullptr;
  if (value == nullptr)
    throw InputError(
        fmt::format("the lifter has no `{}`: it is given by its profile, not by "
                    "height, width and face angles; vary `mill.rows` or `spacing_m`",
                    key));
  if (const auto* const whole = std::get_if<std::int64_t>(&value->data))
    return static_cast<double>(*whole);
  return std::get<double>(value->data);
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
  const Case mill = case_from_document(document);
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
