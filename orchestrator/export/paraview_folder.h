#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "orchestrator/export/liner_surface.h"
#include "orchestrator/export/published_campaign.h"

namespace millwear::orchestrator {

/// A .pvd file that was written.
struct ParaviewSeries {
  std::string file;   ///< its name in the folder
  std::size_t times;  ///< how many files it names
};

struct ParaviewExport {
  std::vector<ParaviewSeries> series;
  std::vector<int> cycles_without_load;    ///< whose liner has no loads
  std::vector<int> cycles_without_charge;  ///< which the series of the charge leave out
};

/// Writes a campaign as series for ParaView (docs/how_to_export.md): the liner after every step and
/// the charge at the beginning of every cycle's measurement over operating hours, and the frames of
/// every cycle over seconds, with the liner as it turns. Each file is whole or absent. The series
/// of an earlier export are removed first, and a series comes after the files that it names. Throws
/// DiskError where the folder cannot be written, and what reading the campaign throws.
[[nodiscard]] ParaviewExport export_to_paraview(const PublishedCampaign& published,
                                                LinerExtent extent,
                                                const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
