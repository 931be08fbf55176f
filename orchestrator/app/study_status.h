#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"
#include "orchestrator/study/study_folder.h"

namespace millwear::orchestrator {

/// The folder of the study that `file` is (it names a `case`; `out` or studies/NAME), or that `out`
/// holds. None where it is about a campaign.
[[nodiscard]] std::optional<StudyFolder> study_folder_of(const std::filesystem::path& file,
                                                         const std::filesystem::path& out);

/// Says how the campaigns in a study's folder stand, and in the queue of Slurm where they were
/// submitted. Throws Failure (usage) where there is no such folder.
void print_study_status(const StudyFolder& folder, OutputForm form);

}  // namespace millwear::orchestrator
