#include "orchestrator/campaign/run_folder.h"

#include <fmt/format.h>

namespace millwear::orchestrator {
namespace {

std::filesystem::path cycle_folder(const std::filesystem::path& root, int cycle) {
  return root / fmt::format("cycle_{:03}", cycle);
}

}  // namespace

std::filesystem::path RunFolder::stage(const StageId& id) const {
  return cycle_folder(root, id.cycle) / name_of(id.kind);
}
std::filesystem::path RunFolder::partial_stage(const StageId& id) const {
  return cycle_folder(root, id.cycle) / fmt::format(".{}.partial", name_of(id.kind));
}

}  // namespace millwear::orchestrator
