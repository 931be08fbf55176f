#include "orchestrator/vtk/pvd_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/contract.h"

namespace millwear::orchestrator {

std::string pvd_file(const std::vector<PvdEntry>& entries) {
  expect(std::ranges::is_sorted(entries, {}, &PvdEntry::time), "a series goes on in time");
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const auto& [time, file] : entries)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, file);
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace millwear::orchestrator
