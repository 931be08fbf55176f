#pragma once
#include <limits>
#include <span>
#include <string_view>

namespace millwear::orchestrator {

/// What a mill is held against.
enum class Quantity {
  power,       ///< net, of the whole length [W]
  shoulder,    ///< from three o'clock on the rising side [degrees]
  toe,         ///< likewise
  face_angle,  ///< of the leading face where the lifter has worn to a given height [degrees]
};

/// As files name it, and as people read it.
struct QuantityName {
  Quantity quantity;
  std::string_view key;
  std::string_view words;
  std::string_view unit;
};

[[nodiscard]] std::span<const QuantityName> quantity_names();
[[nodiscard]] const QuantityName& name_of(Quantity quantity);

/// A value with its standard error; NaN where that is not known.
struct Figure {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace millwear::orchestrator
