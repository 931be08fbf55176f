#include "orchestrator/results/load_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace millwear::orchestrator {

std::optional<std::string> shaking_warning(const std::vector<Conservation>& cycles) {
  const auto path = [](const Conservation& cycle) {
    return std::isnan(cycle.path_over_slip) ? 0.0 : cycle.path_over_slip;
  };
  const auto worst = std::ranges::max_element(cycles, {}, path);
  if (worst == cycles.end() || path(*worst) <= longest_path_over_slip) return std::nullopt;
  return fmt::format(
      "cycle {}: at the limit of friction contacts went {:.1f} times as far as they slid, for "
      "jammed particles shake: the time step is too long for them, and the loss may be up to "
      "a quarter too large; halve `rayleigh_fraction` to see",
      worst->cycle, worst->path_over_slip);
}

std::optional<std::string> jumping_warning(const std::vector<Conservation>& cycles) {
  const auto worst = std::ranges::max_element(cycles, {}, &Conservation::load_scatter);
  if (worst == cycles.end() || worst->load_scatter <= largest_load_scatter) return std::nullopt;
  return fmt::format(
      "cycle {}: the loads about it jump {:.1f} times as far as the scatter within each says, so "
      "they change by more than noise and wear, and the bands are widened by as much; look whether "
      "the charge still segregates (raise `mix_revolutions`) or the loads lie too far apart (lower "
      "`threshold` or `step_tolerance`)",
      worst->cycle, worst->load_scatter);
}

}  // namespace millwear::orchestrator
