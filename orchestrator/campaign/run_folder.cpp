#include "orchestrator/campaign/run_folder.h"

#include <fmt/format.h>

#include "mill/base/failure.h"

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

void check_outside(const std::filesystem::path& file, const RunFolder& folder) {
  const std::filesystem::path from_folder =
      std::filesystem::weakly_canonical(file).lexically_relative(
          std::filesystem::weakly_canonical(folder.root));
  if (from_folder.empty() || *from_folder.begin() == "..") return;
  throw Failure(ExitCode::usage,
                fmt::format("--csv {}: this is among the campaign's own files in {}; name a file "
                            "elsewhere",
                            file.string(), folder.root.string()));
}

}  // namespace millwear::orchestrator
