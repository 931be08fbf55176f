#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mill/load/steady_mixing.h"

namespace millwear {

/// A mixing stretch as it went.
struct MixingRecord {
  MixingPlan plan;
  std::vector<MixedPiece> pieces;
  [[nodiscard]] long steps() const { return static_cast<long>(pieces.size()) * plan.piece; }
  [[nodiscard]] double revolutions() const {
    return static_cast<double>(steps()) / static_cast<double>(plan.revolution);
  }
};

/// As the CSV file that a mixing stretch leaves (docs/file_formats.md).
[[nodiscard]] std::string mixing_csv(const MixingRecord& record);

/// Reads it back, to the last bit. Throws ResultRejected, with `file` and line, where it is torn,
/// of another version or of another plan, or does not end where the plan ends it.
[[nodiscard]] MixingRecord mixing_from_csv(std::string_view text, const std::filesystem::path& file,
                                           const MixingPlan& plan);

/// "mixed for 0.96 revolutions: torque drifts by ...", and that it is not steady where it ended so.
[[nodiscard]] std::string spoken_mixing(const MixingRecord& record);

}  // namespace millwear
