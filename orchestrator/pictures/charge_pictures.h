#pragma once
#include <filesystem>
#include <set>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// The pictures of the charge: of every cycle that recorded it the section and the close-up of the
/// lifters, and of `chosen` cycles all there are. Each is drawn once and kept for the page beside
/// its cycle, and lies as PNG in `results/pictures/cycle_NNN_NAME.png`.
/// Puts them into `data.charge`, and says whether one was drawn. Pictures are drawn side by
/// side on the cores there are. Throws ExternalProgramError where tachyon or gnuplot is missing or
/// fails, DiskError where a picture cannot be written; what was drawn before stays.
bool draw_charge_pictures(const Campaign& campaign, const Ledger& ledger,
                          const std::set<int>& chosen, ShownCharge& charge);

/// Puts the pictures that were kept into `charge`.
void add_kept_pictures(const Campaign& campaign, const Ledger& ledger, ShownCharge& charge);

/// Writes all pictures of one cycle as `NAME.png` into a folder, and the section in each of its
/// frames as `frame_NN.png`, for a film. The campaign is only read. Throws Failure (usage) where
/// the cycle has no `charge.h5`, and as `draw_charge_pictures`.
void write_pictures_of_cycle(const Campaign& campaign, const Ledger& ledger, int cycle,
                             const std::filesystem::path& folder);

/// The first and the last cycle that recorded the charge.
[[nodiscard]] std::set<int> first_and_last(const ShownCharge& charge);

}  // namespace millwear::orchestrator
