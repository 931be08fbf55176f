#pragma once
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace millwear {

/// A number in JSON, which has neither NaN nor infinity: null stands for both.
[[nodiscard]] inline nlohmann::json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// The same where there may be none.
[[nodiscard]] inline nlohmann::json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : nlohmann::json(nullptr);
}

}  // namespace millwear
