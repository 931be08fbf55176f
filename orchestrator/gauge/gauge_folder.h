#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/gauge_reading.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The folder of a case's gauge readings: the one that was named, or `gauge` beside the case file.
[[nodiscard]] std::filesystem::path gauge_folder(const Case& mill,
                                                 const std::optional<std::filesystem::path>& named);

/// What lies above the new liner is another mill's: throws InputError ("PLACE: what") where the
/// lifter, the plate or the profile of a reading stands out of the case's new liner by more than
/// three of its errors and a millimetre for the casting.
void check_under_new_liner(const GaugeReading& reading, const LinerProfile& liner,
                           const std::string& place);

/// The readings of a folder, each checked against the case's new liner. None where the folder has
/// no table. Throws InputError (file:line) for a table that cannot be taken.
[[nodiscard]] std::vector<GaugeReading> readings_in(const std::filesystem::path& folder,
                                                    const Case& mill);

/// The same, and throws InputError where there is none.
[[nodiscard]] std::vector<GaugeReading> needed_readings_in(const std::filesystem::path& folder,
                                                           const Case& mill);

/// Gives the report what the folder's readings tell: heights and profiles.
void add_readings(const std::vector<GaugeReading>& readings, CampaignResults& data);

}  // namespace millwear::orchestrator
