#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace millwear::liggghts {

/// What LIGGGHTS's log of a stretch must show.
struct StretchExpectation {
  std::size_t particles;
  std::size_t triangles;
  long last_step;
};

/// Throws ResultRejected, naming `log_name` and what is missing, unless the log of a stretch shows
/// the sentinel, every particle on every printed step, the whole mesh, finite energies and the last
/// step.
void check_stretch_log(std::string_view log, const std::string& log_name,
                       const StretchExpectation& expected);

}  // namespace millwear::liggghts
