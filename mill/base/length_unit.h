#pragma once
#include <optional>
#include <span>
#include <string_view>

namespace millwear {

enum class LengthUnit { metre, millimetre, centimetre, inch, foot };

/// A unit as users, headers of tables and drawings name it.
struct LengthUnitName {
  LengthUnit unit;
  std::string_view symbol;  ///< as options and messages write it
  double metres;
  int insert_units;  ///< of $INSUNITS in a DXF
};

[[nodiscard]] std::span<const LengthUnitName> length_units();
[[nodiscard]] const LengthUnitName& name_of(LengthUnit unit);

/// The unit that a word says ("mm", "Inches"); none for any other word.
[[nodiscard]] std::optional<LengthUnit> length_unit_called(std::string_view word);

/// The unit of a drawing's $INSUNITS; none where it is unitless or another.
[[nodiscard]] std::optional<LengthUnit> length_unit_of_insert(int insert_units);

}  // namespace millwear
