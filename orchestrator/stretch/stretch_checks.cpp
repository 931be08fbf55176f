#include "orchestrator/stretch/stretch_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/stretch_log.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/run_folder.h"
#include "wear/record/load_accumulator.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

constexpr std::uintmax_t restart_bytes_per_particle = 100;
constexpr std::uintmax_t spare_disk_bytes = 64 << 20;
constexpr std::uintmax_t dump_bytes_per_particle = 200;

/// The load of the longest measurement that may come of it, before it is packed.
std::uintmax_t bytes_of_load(const Case& mill, const liggghts::StretchSteps& steps) {
  if (steps.measure_steps == 0) return 0;
  const long longest = std::max(steps.measure_steps, steps.most_measure_steps);
  const auto blocks =
      static_cast<std::uintmax_t>(mill.wear.time_blocks * longest / steps.measure_steps);
  const auto cells = static_cast<std::uintmax_t>(mill.wear.bins * wear::cells_per_bin);
  return blocks * cells * mill.charge.classes.size() * measure_count * sizeof(double);
}

}  // namespace

void check_free_disk(const Case& mill, const liggghts::StretchSteps& steps, const fs::path& into) {
  const auto particles = static_cast<std::uintmax_t>(totals(mill).particles);
  std::uintmax_t needed = spare_disk_bytes + 2 * 1000 * particles + bytes_of_load(mill, steps);
  if (mill.dem.keep_dumps)
    needed += static_cast<std::uintmax_t>(steps.samples()) * particles * dump_bytes_per_particle;
  const auto free = fs::space(into).available;
  if (free < needed)
    throw DiskError(
        fmt::format("{}: {} MB are free and this stretch needs {} MB; free some, or "
                    "give --out a folder on another disk",
                    into.string(), free >> 20, (needed >> 20) + 1));
}

void check_stretch(const Case& mill, const liggghts::StretchSteps& steps, std::size_t triangles,
                   const fs::path& folder) {
  const fs::path log = folder / names::log;
  const std::size_t particles = totals(mill).particles;
  liggghts::check_stretch_log(read_file(log), log.string(), {particles, triangles, steps.total()});
  const fs::path restart = folder / names::restart;
  if (!fs::exists(restart) || fs::file_size(restart) < restart_bytes_per_particle * particles)
    throw ResultRejected(fmt::format("{}: too short for {} particles; is the disk full?",
                                     restart.string(), particles));
}

void check_recorded(const Case& mill, const fs::path& folder) {
  std::vector<const char*> files = {stage_files::load, stage_files::charge};
  if (mill.dem.keep_events) files.push_back(stage_files::events);
  for (const char* const file : files)
    if (!fs::exists(folder / file))
      throw ResultRejected(fmt::format("{}: the recorder left no {}; see this log for why",
                                       (folder / names::log).string(), file));
}

}  // namespace millwear::orchestrator
