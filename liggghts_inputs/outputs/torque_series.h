#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace millwear::liggghts {

/// Torque on the liner averaged over the steps since the value before.
struct TorqueValue {
  long step;
  double torque;  ///< about +y [N m]; negative while the mill lifts its charge
};

/// Reads the file that `fix ave/time` wrote in a measuring deck.
/// Throws ResultRejected, with `file_name` and line, where it is not complete or not finite.
[[nodiscard]] std::vector<TorqueValue> read_torque_series(std::string_view text,
                                                          const std::string& file_name);

}  // namespace millwear::liggghts
