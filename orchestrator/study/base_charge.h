#pragma once
#include <string>
#include <vector>

#include "orchestrator/dem_run/progress.h"
#include "orchestrator/study/study_folder.h"

namespace millwear::orchestrator {

/// Whether the base case of a study with `charge_from_base` is mixed.
[[nodiscard]] bool has_base_charge(const StudyFolder& folder);

/// Mixes the base case of a study with `charge_from_base`, in the study's folder `charge`, unless
/// that is done. `command` runs the campaign in that folder up to its first mixing. Throws
/// ExternalProgramError where it fails, and Interrupted; the same call then goes on.
void mix_base_charge(const StudyFolder& folder, const std::vector<std::string>& command,
                     Progress& progress);

}  // namespace millwear::orchestrator
