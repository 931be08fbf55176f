#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "mill/case/wear_mechanism.h"

namespace millwear {

/// How the sampled load is smoothed along the profile. docs/physics.md has both.
enum class SmoothingMethod {
  penalised,  ///< as much as the load's own noise asks for
  paper,      ///< the two splines of the 2006 paper, the same for every load
};

/// As the case file writes it.
[[nodiscard]] std::string_view name_of(SmoothingMethod method);

/// What becomes of steel that the smallest simulated particle cannot reach, as in a narrow foot.
enum class ShadowedSteel {
  closing,  ///< smaller particles wear it: it gives way with the surface the smallest one touches
  kept,     ///< nothing wears it
};

/// As the case file writes it.
[[nodiscard]] std::string_view name_of(ShadowedSteel shadowed_steel);

/// The defaults are those of the case file.
struct WearSettings {
  std::vector<WearMechanism> mechanisms;  ///< the law is their sum
  int bins = 120;                         ///< along one pitch
  int time_blocks = 10;                   ///< replicates of the load in one measurement
  double excess_speed = 0.1;              ///< v_0 of the excess kinetic energy of an impact [m/s]
  SmoothingMethod smoothing{};            ///< of the load along the profile
  std::optional<double> resolution{};     ///< of the smoothing; the smallest diameter if none [m]
  ShadowedSteel shadowed_steel{};
};

}  // namespace millwear
