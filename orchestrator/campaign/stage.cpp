#include "orchestrator/campaign/stage.h"

#include <fmt/format.h>

#include <array>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

constexpr std::array<std::string_view, 5> kind_names = {"mesh", "mix", "tune", "dem", "wear"};
constexpr std::array<std::string_view, 5> outcome_names = {"go_on", "height_limit", "plate_limit",
                                                           "reversed", "changed"};

template <class Enum, std::size_t N>
Enum value_named(const std::array<std::string_view, N>& names, std::string_view name) {
  for (std::size_t i = 0; i < N; ++i)
    if (names[i] == name) return static_cast<Enum>(i);
  throw ResultRejected(fmt::format("\"{}\" is none of: {}", name, fmt::join(names, ", ")));
}

}  // namespace

bool begins_anew(Outcome outcome) {
  return outcome == Outcome::reversed || outcome == Outcome::changed;
}

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

}  // namespace millwear::orchestrator
