#pragma once
#include <optional>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/rotation.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/loads/load_along_profile.h"
#include "orchestrator/results/profiles.h"
#include "wear/charge/charge_frames.h"

namespace millwear::orchestrator {

/// A campaign as anyone may look at it, also while it runs: its folder is neither locked nor
/// written to, and only what is published is read.
struct PublishedCampaign {
  Campaign campaign;
  std::optional<Ledger> ledger;      ///< none where only the result tables were kept
  std::vector<ProfileRow> profiles;  ///< the new liner and that after every step, at least one
};

/// The campaign of a case in a folder, or what was kept of it (`results_of`). Throws as that does,
/// and ResultRejected where a file cannot be understood or was changed since it was published.
[[nodiscard]] PublishedCampaign published_campaign(const Case& mill, const RunFolder& folder);

/// The profile after a step of a cycle: by default the latest, and of a cycle its last. Throws
/// Failure (usage), saying which there are, where there is no such step.
[[nodiscard]] const ProfileRow& profile_after(const PublishedCampaign& published,
                                              std::optional<int> cycle, std::optional<int> step);

/// Cycles that begin with a liner that is known: those whose wear is done, and the next one.
[[nodiscard]] int cycles_begun(const PublishedCampaign& published);

/// The profile that a cycle begins with.
[[nodiscard]] const ProfileRow& profile_before(const PublishedCampaign& published, int cycle);

/// What a cycle begins with.
struct CycleStart {
  double operating_hours;  ///< since the liner was new [h]
  LinerProfile liner;      ///< in the steel's frame
  Rotation rotation;       ///< which way the mill turns in the cycle
};

[[nodiscard]] CycleStart start_of(const PublishedCampaign& published, int cycle);

/// The load of a cycle along the liner that it was measured on, as the DEM turns it; nothing where
/// its `load.h5` is not here.
[[nodiscard]] std::optional<LoadAlongProfile> load_of(const PublishedCampaign& published,
                                                      int cycle);

/// The frames of a cycle's charge; nothing where its `charge.h5` is not here.
[[nodiscard]] std::optional<wear::ChargeFrames> frames_of(const PublishedCampaign& published,
                                                          int cycle);

}  // namespace millwear::orchestrator
