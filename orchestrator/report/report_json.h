#pragma once
#include <cstddef>
#include <string>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// What the frames of one cycle take in a report at most, before base64.
inline constexpr std::size_t report_frame_bytes = 1'600'000;

/// The data as JSON, in SI units and radians, NaN as null. Its text can stand inside a `<script>`
/// element whatever the names hold: `<` is written as an escape.
[[nodiscard]] std::string report_json(const CampaignResults& data,
                                      std::size_t most_frame_bytes = report_frame_bytes);

}  // namespace millwear::orchestrator
