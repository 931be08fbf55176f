#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "wear/band/campaign_band.h"
#include "wear/surface/centre_path.h"

namespace millwear::wear {

/// A mill whose wear is known, and how well its loads are measured.
struct KnownMill {
  LinerProfile liner;  ///< new
  double section;      ///< of the new lifter, of which the shares in the settings are [m2]
  double growth;       ///< of the rate with the depth that the first node has lost [1/m]
  RollingBalls balls;
  double resolution;     ///< of smoothing [m]
  double whole_scatter;  ///< of a time block as a whole, of the rate [-]
  double bin_scatter;    ///< of a time block's bin, of the rate [-]
};

/// Depth rate of a flat of a new liner [m/s].
inline constexpr double known_depth_rate = 1e-9;

/// A campaign from noisy time blocks to the worn liner.
struct NoisyCampaign {
  std::vector<WornCycle> cycles;  ///< with 200 replicates each
  LinerProfile worn;              ///< at the end
  double duration;                ///< of milling [s]
};

/// Wears a known mill's liner up to a limit of `settings` or for `longest` [s].
[[nodiscard]] NoisyCampaign noisy_campaign(
    const KnownMill& mill, const CampaignSettings& settings, std::uint64_t seed,
    double longest = std::numeric_limits<double>::infinity());

}  // namespace millwear::wear
