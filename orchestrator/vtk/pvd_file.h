#pragma once
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// One file of a series.
struct PvdEntry {
  double time;       ///< in the unit of the series
  std::string file;  ///< named from the folder of the .pvd file
};

/// The bytes of a .pvd file, which ParaView opens as one data set that changes with time. The
/// entries are in increasing order of time (std::logic_error).
[[nodiscard]] std::string pvd_file(const std::vector<PvdEntry>& entries);

}  // namespace millwear::orchestrator
