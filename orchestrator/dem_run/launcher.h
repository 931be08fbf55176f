#pragma once
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// The words that start a program on so many MPI ranks. `launcher` is what `[dem] launcher` says:
/// - "mpirun": Open MPI's, on as many slots as it takes. In an allocation of one task with several
///   cores Open MPI counts one slot, so it is told not to. Ranks with a core each do not yield it
///   while they wait, which costs a fifth; others have to.
/// - "srun": Slurm's.
/// - anything else: words with {ranks} and, as the last, {command}.
/// Throws InputError for words without these or with another word in braces, ExternalProgramError
/// where mpirun or srun is missing.
[[nodiscard]] std::vector<std::string> launch_words(const std::string& launcher, int ranks,
                                                    const std::vector<std::string>& command);

/// Throws Failure (usage) where srun has started several copies of this program, which would all do
/// the same work in one folder.
void check_started_once();

}  // namespace millwear::orchestrator
