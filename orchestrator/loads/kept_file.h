#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "orchestrator/campaign/campaign.h"

namespace millwear::orchestrator {

/// The key of what is worked out from a case and other inputs (their hashes): it is another one for
/// every version of this program and of the kept files.
[[nodiscard]] std::string kept_key(const Case& mill, std::string_view inputs);

/// Where a cycle keeps what is worked out from its stages, `cycle_NNN/kept/NAME`. None of it is
/// needed: what is missing, damaged or of other inputs is worked out again.
[[nodiscard]] std::filesystem::path kept_file(const RunFolder& folder, int cycle,
                                              std::string_view name);

/// Publishes bytes under their key. Throws DiskError.
void keep(const std::filesystem::path& file, std::string_view key, std::string_view bytes);

/// The bytes that were kept under this key; nothing where there are none, or not as they were
/// written.
[[nodiscard]] std::optional<std::string> kept_bytes(const std::filesystem::path& file,
                                                    std::string_view key);

}  // namespace millwear::orchestrator
