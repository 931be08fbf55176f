#pragma once
#include <filesystem>
#include <string>

#include "liggghts_inputs/decks/charge_data.h"
#include "orchestrator/campaign/campaign.h"

namespace millwear::orchestrator {

/// The charge that a campaign begins with in place of a packing, as `charge_from` names it.
struct ChargeSource {
  std::filesystem::path restart;
  Case mill;  ///< that the charge was simulated in
};

/// Finds it: in a cycle's folder what its measurement left, or its mixing where there is none; in a
/// campaign's folder that of its first cycle. `folder` is `charge_from` as the program can reach
/// it. Throws InputError where there is none, or where it is of another mill (`check_same_charge`).
[[nodiscard]] ChargeSource charge_source(const Case& mill, const std::filesystem::path& folder);

/// A charge to begin with, and what there is to say of it.
struct FirstCharge {
  std::vector<liggghts::PlacedParticle> particles;
  std::string words;  ///< empty for a packing
};

/// Packs the charge of a cycle that is mixed anew, or in the first one takes that of `charge_from`,
/// which LIGGGHTS writes down in `into`.
[[nodiscard]] FirstCharge first_charge(const Campaign& campaign, int cycle,
                                       const std::filesystem::path& into);

}  // namespace millwear::orchestrator
