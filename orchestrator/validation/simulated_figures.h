#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/validation/figure.h"
#include "orchestrator/validation/published_figures.h"

namespace millwear::orchestrator {

using SimulatedFigures = std::map<Quantity, Figure>;

/// What a campaign gives for each published quantity: of the charge what its first measurement
/// gives, of the liner what its history gives, linearly between two geometry steps. A power is that
/// of the slice times the mill's length over the slice's. A face angle has no error: its noise is
/// that of other seeds. Throws Failure where the campaign has not come so far.
[[nodiscard]] SimulatedFigures simulated_figures(const Campaign& campaign,
                                                 const std::vector<PublishedFigure>& published);

/// The kept figures of a validation case, `simulated.csv`.
[[nodiscard]] std::string simulated_csv(const SimulatedFigures& figures);
[[nodiscard]] SimulatedFigures read_simulated_csv(const std::filesystem::path& file);

}  // namespace millwear::orchestrator
