#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// millwear-recorder in the place of liggghts, and what it is told.
struct RecorderProgram {
  std::filesystem::path program;
  std::vector<std::string> arguments;
};

/// LIGGGHTS on one deck, in the folder where the deck lies.
struct StretchRun {
  std::filesystem::path folder;
  int ranks;
  /// Called with every line LIGGGHTS prints, for progress.
  std::function<void(std::string_view)> take_line;
  std::optional<RecorderProgram> recorder{};
  std::string launcher = "mpirun";  ///< `launch_words` says what that may be
};

/// A named pipe in the run's folder that LIGGGHTS writes a dump into, and who reads it.
struct DumpPipe {
  const char* name;
  std::function<void(std::string_view)> take;
};

/// The recorder beside this program, or on PATH. Throws ExternalProgramError where it is missing.
[[nodiscard]] std::filesystem::path recorder_program();

/// What runs a deck of which nothing is recorded: the recorder, whose search for neighbours is the
/// faster, or the plain liggghts (none) where the case wants that. Either ends in the same bits.
/// Throws as `recorder_program` does.
[[nodiscard]] std::optional<RecorderProgram> unrecorded_program(const Case& mill, int ranks);

/// Throws ExternalProgramError if the launcher, liggghts (naming the Debian package) or, where the
/// case wants it, the recorder is missing; InputError for a launcher that starts nothing, Failure
/// (usage) where srun has started this program several times.
void check_liggghts_is_installed(const DemSettings& settings);

/// Runs the deck to its end, feeding the dumps to their readers as they come; what LIGGGHTS prints
/// is kept in its log file in the folder. The pipes are made before and removed after.
/// Returns the exit code, which proves nothing: check the log (liggghts_inputs/decks/stretch.h).
/// Throws ExternalProgramError if mpirun or liggghts is missing, DiskError where the log cannot be
/// written, Interrupted, and whatever a reader throws; LIGGGHTS is then stopped.
int run_liggghts(const StretchRun& run, const std::vector<DumpPipe>& pipes);

/// Feeds a dump that was kept as a file to its reader.
void read_dump_file(const std::filesystem::path& file,
                    const std::function<void(std::string_view)>& take);

}  // namespace millwear::orchestrator
