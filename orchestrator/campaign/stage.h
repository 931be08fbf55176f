#pragma once
#include <compare>
#include <string>
#include <string_view>

namespace millwear::orchestrator {

/// What a cycle consists of. A stage is atomic: it is published whole or runs again from its start.
enum class StageKind {
  mesh,  ///< liner profile -> STL, STEP, DXF
  mix,   ///< pack the charge anew, let it fall and mix: in cycle 0 and after a reversal or change
  tune,  ///< time neighbour skins on the mixed charge: in cycle 0, where the case wants it
  dem,   ///< settle on the new mesh and measure the load
  wear,  ///< load -> loss of steel -> next profile
};

struct StageId {
  int cycle;
  StageKind kind;
  auto operator<=>(const StageId&) const = default;
};

/// How a published stage leaves the campaign.
enum class Outcome {
  go_on,
  height_limit,
  plate_limit,
  reversed,  ///< it goes on, and the mill turns the other way from now
  changed,   ///< it goes on, with another speed or charge from now
};

/// Whether the next cycle begins with a new charge: the mirrored steel may stand where the last one
/// lies, or the charge is another one.
[[nodiscard]] bool begins_anew(Outcome outcome);

[[nodiscard]] std::string_view name_of(StageKind kind);
[[nodiscard]] std::string_view name_of(Outcome outcome);
/// "cycle 3 dem"
[[nodiscard]] std::string name_of(const StageId& id);

/// The inverse of `name_of`. Throws ResultRejected for a name that is none.
[[nodiscard]] StageKind stage_kind_from(std::string_view name);
[[nodiscard]] Outcome outcome_from(std::string_view name);

}  // namespace millwear::orchestrator
