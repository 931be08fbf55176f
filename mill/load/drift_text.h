#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "mill/load/steady_mixing.h"

namespace millwear {

/// "torque drifts by 2.1 % (limit 5 %), kinetic energy by 0.8 % (limit 5 %), class 3 on the liner
/// by 4 % (limit 7 %)" with the classes counted from 1, or that it is too early to tell.
[[nodiscard]] std::string spoken_drift(const std::optional<MixingDrift>& drift);

/// The same without limits and energy: "torque drifts by 2.1 %".
[[nodiscard]] std::string spoken_torque_drift(const std::optional<MixingDrift>& drift);

/// Reads what `spoken_drift` gave, to the digits that it prints. False for any other text.
[[nodiscard]] bool read_drift(std::string_view text, std::optional<MixingDrift>& drift);

}  // namespace millwear
