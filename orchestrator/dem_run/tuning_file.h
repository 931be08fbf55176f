#pragma once
#include <filesystem>
#include <string>

#include "orchestrator/dem_run/tuning.h"

namespace millwear::orchestrator {

/// A tuning as JSON, `millwear tuning` 2 (docs/file_formats.md).
[[nodiscard]] std::string tuning_json(const Tuning& tuning);

/// Reads such a file. Throws DiskError where it cannot be read, and ResultRejected where it cannot
/// be understood or its chosen settings are none that were tried.
[[nodiscard]] Tuning read_tuning(const std::filesystem::path& file);

/// A table of the trials, the fastest settings, and what to write into the case.
[[nodiscard]] std::string tuning_text(const Tuning& tuning);

/// "43.2" or "1286" steps a second.
[[nodiscard]] std::string spoken_speed(const Tuning& tuning, const DeckTrial& trial);

/// "skin_m = 0.0212" and, where there was a choice, "rank_split = \"axis\"": the lines for [dem].
[[nodiscard]] std::string dem_lines(const Tuning& tuning);

}  // namespace millwear::orchestrator
