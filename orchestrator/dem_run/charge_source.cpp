#include "orchestrator/dem_run/charge_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "liggghts_inputs/decks/carried_charge.h"
#include "liggghts_inputs/decks/charge_packing.h"
#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/contact_join.h"
#include "liggghts_inputs/outputs/snapshot_reader.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/dem_run/stretch_run.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;
using liggghts::PlacedParticle;

constexpr const char* charge_dump = "charge.dump";

/// The restart file that a cycle has left, empty where it has left none.
fs::path restart_in(const fs::path& cycle) {
  for (const char* const stage : {"dem", "mix"})
    if (const fs::path file = cycle / stage / names::restart; fs::exists(file)) return file;
  return {};
}

std::size_t class_in(const Case& mill, std::size_t type, double diameter, const fs::path& file) {
  const auto found = class_of(mill.charge.classes, type - 1, diameter);
  if (!found)
    throw ResultRejected(
        fmt::format("{}: a particle of {:g} m and atom type {} is of no class of {}", file.string(),
                    diameter, type, mill.file.string()));
  return *found;
}

/// The particles of a snapshot in the order of their numbers, of which the order of the ranks and
/// of LIGGGHTS's sorting is none.
std::vector<PlacedParticle> particles_of(const liggghts::Snapshot& snapshot,
                                         const ChargeSource& source) {
  enum Column { id, type, radius, x, vx = 6, omega_x = 9 };
  std::vector<std::pair<long, PlacedParticle>> numbered;
  for (std::size_t i = 0; i < snapshot.rows(); ++i) {
    const auto row = snapshot.row(i);
    const auto vector = [&](std::size_t first) {
      return Eigen::Vector3d(row[first], row[first + 1], row[first + 2]);
    };
    numbered.push_back({static_cast<long>(row[id]),
                        {vector(x),
                         class_in(source.mill, static_cast<std::size_t>(row[type]),
                                  2.0 * row[radius], source.restart),
                         vector(vx), vector(omega_x)}});
  }
  std::ranges::sort(numbered, {}, &std::pair<long, PlacedParticle>::first);
  std::vector<PlacedParticle> particles;
  for (auto& [number, particle] : numbered) particles.push_back(particle);
  return particles;
}

/// Has LIGGGHTS write the charge down, in a folder of its own within `into` that does not stay.
std::vector<PlacedParticle> read_charge(const ChargeSource& source, const std::string& launcher,
                                        const fs::path& into) {
  const fs::path folder = into / "charge_source";
  make_folder(folder);
  write_file(folder / names::deck,
             liggghts::charge_reading_deck(fs::absolute(source.restart).string(), charge_dump));
  std::vector<PlacedParticle> particles;
  liggghts::SnapshotReader reader(
      source.restart.string(), liggghts::spin_columns,
      [&](const liggghts::Snapshot& snapshot) { particles = particles_of(snapshot, source); });
  run_liggghts({folder, 1, {}, {}, launcher},
               {{charge_dump, [&](std::string_view piece) { reader.feed(piece); }}});
  reader.finish();
  const std::size_t wanted = totals(source.mill).particles;
  if (particles.size() != wanted)
    throw ResultRejected(fmt::format("{}: it gives {} particles and its campaign has {}; see {}",
                                     source.restart.string(), particles.size(), wanted,
                                     (folder / names::log).string()));
  fs::remove_all(folder);
  return particles;
}

}  // namespace

ChargeSource charge_source(const Case& mill, const fs::path& named) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(named));
  const bool is_cycle = folder.filename().string().starts_with("cycle_");
  const fs::path cycle = is_cycle ? folder : folder / "cycle_000";
  const fs::path locked_case = RunFolder{cycle.parent_path()}.locked_case();
  const fs::path restart = restart_in(cycle);
  if (restart.empty() || !fs::exists(locked_case))
    throw InputError(fmt::format(
        "{}: `charge_from` in [dem] names {}, where no campaign has left a charge; name the folder "
        "of one that has come to its first mixing, or of one of its cycles",
        mill.file.string(), folder.string()));
  ChargeSource source{restart, read_case(locked_case)};
  liggghts::check_same_charge(mill, source.mill);
  return source;
}

FirstCharge first_charge(const Campaign& campaign, int cycle, const fs::path& into) {
  Case mill = campaign.mill;
  mill.liner = dem_liner_of_cycle(campaign, cycle);
  if (cycle > 0 || !mill.dem.charge_from) return {liggghts::pack_charge(mill), ""};
  const ChargeSource source = charge_source(mill, campaign.folder.root / *mill.dem.charge_from);
  auto carried = liggghts::carried_charge(mill, read_charge(source, mill.dem.launcher, into));
  return {std::move(carried.particles),
          fmt::format("charge of {}: {} particles moved out of the steel, {} added, {} left behind",
                      source.restart.string(), carried.moved, carried.added, carried.left)};
}

}  // namespace millwear::orchestrator
