#include "mill/base/length_unit.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mill/base/user_table.h"

namespace millwear {
namespace {

constexpr std::array<LengthUnitName, 5> units{{
    {LengthUnit::metre, "m", 1.0, 6},
    {LengthUnit::millimetre, "mm", 1e-3, 4},
    {LengthUnit::centimetre, "cm", 1e-2, 5},
    {LengthUnit::inch, "in", 0.0254, 1},
    {LengthUnit::foot, "ft", 0.3048, 2},
}};

constexpr std::array<std::pair<std::string_view, LengthUnit>, 11> other_words{{
    {"metre", LengthUnit::metre},
    {"metres", LengthUnit::metre},
    {"meter", LengthUnit::metre},
    {"meters", LengthUnit::metre},
    {"millimetres", LengthUnit::millimetre},
    {"millimeters", LengthUnit::millimetre},
    {"inch", LengthUnit::inch},
    {"inches", LengthUnit::inch},
    {"\"", LengthUnit::inch},
    {"foot", LengthUnit::foot},
    {"feet", LengthUnit::foot},
}};

}  // namespace

std::span<const LengthUnitName> length_units() { return units; }

const LengthUnitName& name_of(LengthUnit unit) { return units[static_cast<std::size_t>(unit)]; }

std::optional<LengthUnit> length_unit_called(std::string_view word) {
  const std::string lower = lower_case(word);
  if (const auto found = std::ranges::find(units, lower, &LengthUnitName::symbol);
      found != units.end())
    return found->unit;
  const auto other =
      std::ranges::find(other_words, lower, &std::pair<std::string_view, LengthUnit>::first);
  if (other != other_words.end()) return other->second;
  return std::nullopt;
}

std::optional<LengthUnit> length_unit_of_insert(int insert_units) {
  const auto found = std::ranges::find(units, insert_units, &LengthUnitName::insert_units);
  if (found == units.end()) return std::nullopt;
  return found->unit;
}

}  // namespace millwear
