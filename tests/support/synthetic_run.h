#pragma once
#include <filesystem>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"

namespace millwear::orchestrator {

/// A campaign's folder made without a DEM: `cycles` cycles of the example mill, each with a load of
/// random contacts, its measurement, and steps that lower the lifter.
struct SyntheticRun {
  Campaign campaign;
  Ledger ledger;
};

[[nodiscard]] SyntheticRun synthetic_run(const std::filesystem::path& folder, int cycles);

/// The ledger as it was after the wear of a cycle.
[[nodiscard]] Ledger ledger_after(const Ledger& ledger, int cycle);

}  // namespace millwear::orchestrator
