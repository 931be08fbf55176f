#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// The work of one chunk of a stage.
struct ChunkWork {
  std::filesystem::path folder;  ///< its own, beside the stage's
  /// All that decides what it leaves, beside the files that `write_inputs` writes.
  std::string depends_on;
  std::function<void(const std::filesystem::path& into)> write_inputs;
  std::function<void(const std::filesystem::path& into)> simulate;
};

/// Does the work in `begin_work`'s folder and publishes it by a rename, unless the folder
/// stands there as the same work has left it. Throws DiskError and what the work throws.
void run_chunk(const Campaign& campaign, const ChunkWork& work);

/// Removes the chunks of a stage, done or not.
void remove_chunks(const Campaign& campaign, const StageId& stage);

/// How many chunks of a stage are done that is not published.
[[nodiscard]] int chunks_done(const Campaign& campaign, const StageId& stage);

}  // namespace millwear::orchestrator
