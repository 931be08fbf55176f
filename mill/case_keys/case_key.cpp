#include "mill/case_keys/case_key.h"

#include <fmt/format.h>

#include <cmath>

namespace millwear {

bool KeyRange::holds(double value) const {
  return std::isfinite(value) && (above_low ? value > low : value >= low) && value <= high;
}

std::string KeyRange::text() const {
  if (std::isinf(high)) {
    return std::isinf(low) ? "" : fmt::format("{} {}", above_low ? "above" : "at least", low);
  }
  return above_low ? fmt::format("above {} and up to {}", low, high)
                   : fmt::format("from {} to {}", low, high);
}

}  // namespace millwear
