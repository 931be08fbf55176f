#include "orchestrator/pictures/charge_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <span>
#include <string_view>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/loads/cycle_load.h"
#include "orchestrator/loads/kept_file.h"
#include "orchestrator/pictures/charge_views.h"
#include "orchestrator/pictures/field_pictures.h"
#include "orchestrator/pictures/polar_picture.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/on_all_cores.h"
#include "orchestrator/process/usable_cores.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// What the pictures of one cycle are drawn from.
struct PictureSource {
  const ShownCharge& charge;
  const ChargeOfCycle& cycle;
  const CycleLoad& load;

  [[nodiscard]] ChargeAtInstant instant(Colouring colouring) const {
    return {*cycle.frames, 0, cycle.liner, colouring, class_colours(charge.classes),
            charge.fastest};
  }
};

/// A picture without a JPEG stays out of the page, which draws its own from the data.
ChargePicture only_png(std::string png) { return {std::move(png), ""}; }

enum class Wanted { of_every_cycle, of_chosen_cycles };

struct PictureKind {
  std::string_view name;
  Wanted wanted;
  ChargePicture (*draw)(const PictureSource& source);
};

const std::vector<PictureKind> kinds{
    {"section", Wanted::of_every_cycle,
     [](const PictureSource& s) { return section_picture(s.instant(Colouring::speed)); }},
    {"close_up", Wanted::of_every_cycle,
     [](const PictureSource& s) { return close_up_picture(s.instant(Colouring::speed)); }},
    {"section_by_size", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return section_picture(s.instant(Colouring::size)); }},
    {"slice", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return slice_picture(s.instant(Colouring::speed)); }},
    {"streaks", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return streaks_picture(s.cycle, s.charge.fastest); }},
    {"occupancy", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return only_png(occupancy_picture(s.cycle)); }},
    {"velocity", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return only_png(velocity_picture(s.cycle, s.charge.fastest)); }},
    {"collision_power", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return only_png(collision_power_picture(s.cycle)); }},
    {"segregation", Wanted::of_chosen_cycles,
     [](const PictureSource& s) { return only_png(segregation_picture(s.cycle)); }},
    {"polar", Wanted::of_chosen_cycles, [](const PictureSource& s) {
       return only_png(s.load.polar ? polar_picture(*s.load.polar, s.load.along) : "");
     }}};

fs::path png_file(const Campaign& campaign, int cycle, std::string_view name) {
  return campaign.folder.results() / "pictures" / fmt::format("cycle_{:03}_{}.png", cycle, name);
}

fs::path jpeg_file(const Campaign& campaign, int cycle, std::string_view name) {
  return kept_file(campaign.folder, cycle, fmt::format("picture_{}", name));
}

/// The hash of what a cycle's DEM published.
const std::string& dem_output(const Ledger& ledger, int cycle, const char* file) {
  return ledger.find({cycle, StageKind::dem})->outputs.at(file);
}

/// What the pictures of a cycle follow from: it changes with the program, too.
std::string key_of(const Campaign& campaign, const Ledger& ledger, int cycle) {
  return kept_key(campaign.mill, dem_output(ledger, cycle, stage_files::charge));
}

struct CycleWork {
  ChargeOfCycle& cycle;
  std::string key;
  std::vector<const PictureKind*> missing{};
};

/// Takes the kept pictures of a cycle and notes which of the wanted are missing.
CycleWork work_of(const Campaign& campaign, const Ledger& ledger, bool chosen,
                  ChargeOfCycle& cycle) {
  CycleWork work{cycle, key_of(campaign, ledger, cycle.cycle)};
  for (const PictureKind& kind : kinds) {
    const auto kept = kept_bytes(jpeg_file(campaign, cycle.cycle, kind.name), work.key);
    if (kept && !kept->empty()) cycle.pictures[std::string(kind.name)] = *kept;
    const bool wanted = chosen || kind.wanted == Wanted::of_every_cycle;
    const bool lies_there = kept && fs::exists(png_file(campaign, cycle.cycle, kind.name));
    if (wanted && !lies_there) work.missing.push_back(&kind);
  }
  return work;
}

/// What a cycle's missing pictures are drawn from.
struct CycleRecord {
  CycleWork& work;
  ShownCharge charge;
  CycleLoad load;
};

/// A picture that is missing, and where its JPEG goes.
struct MissingPicture {
  const CycleRecord& record;
  const PictureKind& kind;
  std::string jpeg{};
};

void draw(const Campaign& campaign, MissingPicture& missing) {
  const auto& [work, charge, load] = missing.record;
  const int cycle = work.cycle.cycle;
  ChargePicture picture = missing.kind.draw({charge, charge.cycles.front(), load});
  if (!picture.png.empty()) publish(png_file(campaign, cycle, missing.kind.name), picture.png);
  keep(jpeg_file(campaign, cycle, missing.kind.name), work.key, picture.jpeg);
  missing.jpeg = std::move(picture.jpeg);
}

/// Reads the cycles first and draws all of their pictures then: HDF5 serves one thread only.
void draw(const Campaign& campaign, const Ledger& ledger, std::span<CycleWork*> works) {
  std::deque<CycleRecord> records;
  std::deque<MissingPicture> missing;
  for (CycleWork* work : works) {
    const int cycle = work->cycle.cycle;
    const auto& record = records.emplace_back(
        CycleRecord{*work, charge_of_cycles(campaign, {cycle}),
                    load_of_cycle(campaign, cycle, dem_output(ledger, cycle, stage_files::load))});
    if (!record.charge.cycles.front().frames) continue;
    for (const PictureKind* kind : work->missing) missing.push_back(MissingPicture{record, *kind});
  }
  for_each_on_all_cores(missing.size(), [&](std::size_t i) { draw(campaign, missing[i]); });
  for (MissingPicture& one : missing)
    if (!one.jpeg.empty())
      one.record.work.cycle.pictures[std::string(one.kind.name)] = std::move(one.jpeg);
}

std::vector<CycleWork> works_of(const Campaign& campaign, const Ledger& ledger,
                                const std::set<int>& chosen, ShownCharge& charge) {
  std::vector<CycleWork> works;
  for (ChargeOfCycle& cycle : charge.cycles)
    works.push_back(work_of(campaign, ledger, chosen.contains(cycle.cycle), cycle));
  return works;
}

/// Throws ExternalProgramError before anything is drawn.
void check_renderers() {
  static_cast<void>(program_on_path("tachyon", "tachyon-bin-nox"));
  static_cast<void>(program_on_path("gnuplot", "gnuplot-nox"));
}

}  // namespace

bool draw_charge_pictures(const Campaign& campaign, const Ledger& ledger,
                          const std::set<int>& chosen, ShownCharge& charge) {
  auto works = works_of(campaign, ledger, chosen, charge);
  std::vector<CycleWork*> incomplete;
  for (CycleWork& work : works)
    if (!work.missing.empty()) incomplete.push_back(&work);
  if (incomplete.empty()) return false;
  check_renderers();
  fs::create_directories(campaign.folder.results() / "pictures");
  // A few cycles at once keep all cores busy, and memory constant in the length of a campaign.
  const auto at_once = static_cast<std::size_t>(2 * usable_cores());
  for (std::size_t i = 0; i < incomplete.size(); i += at_once)
    draw(campaign, ledger,
         std::span(incomplete).subspan(i, std::min(at_once, incomplete.size() - i)));
  return true;
}

void add_kept_pictures(const Campaign& campaign, const Ledger& ledger, ShownCharge& charge) {
  static_cast<void>(works_of(campaign, ledger, {}, charge));
}

void write_pictures_of_cycle(const Campaign& campaign, const Ledger& ledger, int cycle,
                             const fs::path& folder) {
  const ShownCharge charge = charge_of_cycles(campaign, {cycle});
  if (charge.cycles.empty() || !charge.cycles.front().frames)
    throw Failure(
        ExitCode::usage,
        fmt::format("cycle {} has no dem/charge.h5 with frames; --cycle chooses another", cycle));
  check_renderers();
  make_folder(folder);
  const CycleLoad load =
      look_at_load_of_cycle(campaign, cycle, dem_output(ledger, cycle, stage_files::load));
  const PictureSource source{charge, charge.cycles.front(), load};
  const std::size_t frames = source.cycle.frames->frames();
  for_each_on_all_cores(kinds.size() + frames, [&](std::size_t i) {
    if (i < kinds.size()) {
      const std::string png = kinds[i].draw(source).png;
      if (!png.empty()) publish(folder / fmt::format("{}.png", kinds[i].name), png);
      return;
    }
    ChargeAtInstant instant = source.instant(Colouring::speed);
    instant.frame = i - kinds.size();
    publish(folder / fmt::format("frame_{:02}.png", instant.frame), section_picture(instant).png);
  });
}

std::set<int> first_and_last(const ShownCharge& charge) {
  if (charge.cycles.empty()) return {};
  return {charge.cycles.front().cycle, charge.cycles.back().cycle};
}

}  // namespace millwear::orchestrator
