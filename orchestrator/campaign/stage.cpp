#include "orchestrator/campaign/stage.h"

#include <fmt/format.h>

#include <array>

#include "mill/base/failure.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {
namespace {

constexpr std::array<std::string_view, 5> kind_names = {"mesh", "mix", "tune", "dem", "wear"};
constexpr std::array<std::string_view, 4> outcome_names = {"go_on", "height_limit", "plate_limit",
                                                           "reversed"};

template <class Enum, std::size_t N>
Enum value_named(const std::array<std::string_view, N>& names, std::string_view name) {
  for (std::size_t i = 0; i < N; ++i)
    if (names[i] == name) return static_cast<Enum>(i);
  throw ResultRejected(fmt::format("\"{}\" is none of: {}", name, fmt::join(names, ", ")));
}

std::filesystem::path cycle_folder(const std::filesystem::path& root, int cycle) {
  return root / fmt::format("cycle_{:03}", cycle);
}

}  // namespace

std::string_view name_of(StageKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }
std::string_view name_of(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)];
}
std::string name_of(const StageId& id) {
  return fmt::format("cycle {} {}", id.cycle, name_of(id.kind));
}
StageKind stage_kind_from(std::string_view name) {
  return value_named<StageKind>(kind_names, name);
}
Outcome outcome_from(std::string_view name) { return value_named<Outcome>(outcome_names, name); }

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
