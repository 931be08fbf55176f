#pragma once
#include <filesystem>

#include "orchestrator/campaign/campaign.h"

namespace millwear::orchestrator {

/// An empty folder in which the files of a stage, or of a chunk of it, grow before they are
/// published. `partial` is its place in a cycle of the campaign's folder: it is that folder itself,
/// or with `campaign.scratch` one on that disk, around which the stages that the work reads are
/// links. Throws DiskError.
[[nodiscard]] std::filesystem::path begin_work(const Campaign& campaign,
                                               const std::filesystem::path& partial);

/// Brings what has grown to its place, from where a rename publishes it. Throws DiskError.
void end_work(const std::filesystem::path& work, const std::filesystem::path& partial);

/// Removes what a campaign has on the scratch disk.
void leave_scratch(const Campaign& campaign);

}  // namespace millwear::orchestrator
