#pragma once
#include <cstddef>
#include <string>

#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The charge of every cycle as the page's JSON: maps over the section and polar maps in eight
/// bits, with the same scale for all cycles, landmarks, and the frames that there are, thinned to
/// `most_frame_bytes` of a cycle before packing.
[[nodiscard]] std::string charge_json(const CampaignResults& data, std::size_t most_frame_bytes);

}  // namespace millwear::orchestrator
