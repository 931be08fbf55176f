#include "orchestrator/pictures/colour_ramp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace millwear::orchestrator {
namespace {

/// Nine equally spaced colours of viridis.
const std::array<Rgb, 9> stops{{{0.267, 0.005, 0.329},
                                {0.283, 0.141, 0.458},
                                {0.230, 0.322, 0.546},
                                {0.173, 0.449, 0.558},
                                {0.128, 0.567, 0.551},
                                {0.158, 0.684, 0.502},
                                {0.369, 0.789, 0.383},
                                {0.678, 0.864, 0.190},
                                {0.993, 0.906, 0.144}}};
constexpr double spans = stops.size() - 1;

}  // namespace

Rgb ramp_colour(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * spans;
  const auto low = static_cast<std::size_t>(std::min(std::floor(at), spans - 1.0));
  const double rest = at - static_cast<double>(low);
  return (1.0 - rest) * stops[low] + rest * stops[low + 1];
}

std::string ramp_palette() {
  std::string text = "set palette defined (";
  for (std::size_t i = 0; i < stops.size(); ++i)
    text +=
        fmt::format("{}{} '{}'", i == 0 ? "" : ", ", static_cast<double>(i) / spans, hex(stops[i]));
  return text + ")\n";
}

std::string hex(const Rgb& colour) {
  const auto part = [&](int i) { return static_cast<int>(std::lround(255.0 * colour[i])); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

}  // namespace millwear::orchestrator
