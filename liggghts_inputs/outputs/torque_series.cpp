#include "liggghts_inputs/outputs/torque_series.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "mill/base/failure.h"

namespace millwear::liggghts {

std::vector<TorqueValue> read_torque_series(std::string_view text, const std::string& file_name) {
  std::vector<TorqueValue> series;
  for (long number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.starts_with('#')) continue;
    TorqueValue value{};
    const char* const stop = line.data() + line.size();
    const auto step = std::from_chars(line.data(), stop, value.step);
    if (step.ec == std::errc{} && step.ptr != stop && *step.ptr == ' ') {
      const auto torque = std::from_chars(step.ptr + 1, stop, value.torque);
      const std::string_view rest(torque.ptr, static_cast<std::size_t>(stop - torque.ptr));
      if (torque.ec == std::errc{} && rest.find_first_not_of(' ') == rest.npos &&
          std::isfinite(value.torque) && end != std::string_view::npos) {
        series.push_back(value);
        continue;
      }
    }
    throw ResultRejected(fmt::format("{}:{}: not a line of `step torque`: \"{}\"; the file is torn",
                                     file_name, number, line.substr(0, 80)));
  }
  return series;
}

}  // namespace millwear::liggghts
