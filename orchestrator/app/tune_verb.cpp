#include "orchestrator/app/tune_verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/case_difference.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "orchestrator/dem_run/tuning_file.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/stages/run_stage.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// How long a charge of the trial's own moves before it: thrown, landed and lifted again.
constexpr double flight_revolutions = 0.25;
constexpr double share_before_trial = 0.5;

/// A folder for the trial alone, removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "millwear_tune_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw DiskError(
          fmt::format("{}: no folder for the trial can be made ({}); name another "
                      "place for it with TMPDIR",
                      name, std::strerror(errno)));
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Throws InputError unless mill, charge and contacts are those of the campaign in the folder.
void check_same_charge(const Case& here, const Campaign& campaign) {
  const Case& there = campaign.mill;
  Case like_there = here;
  like_there.wear = there.wear;
  like_there.campaign = there.campaign;
  like_there.dem = there.dem;
  like_there.dem.modulus_reduction = here.dem.modulus_reduction;
  like_there.dem.rayleigh_fraction = here.dem.rayleigh_fraction;
  like_there.dem.longest_time_step = here.dem.longest_time_step;
  like_there.dem.time_step = here.dem.time_step;
  like_there.dem.rolling_friction = here.dem.rolling_friction;
  like_there.dem.mesh_tolerance = here.dem.mesh_tolerance;
  if (const auto texts = differences(like_there, there); !texts.empty())
    throw InputError(fmt::format(
        "{}: the mixed charge in {} is of another case; it differs in {}; name a folder without a "
        "campaign with --out for a trial on a charge of its own",
        here.file.string(), campaign.folder.root.string(), fmt::join(texts, ", ")));
}

void copy_stage(const RunFolder& from, const RunFolder& to, StageKind kind) {
  const StageId stage{0, kind};
  make_folder(to.stage(stage).parent_path());
  fs::copy(from.stage(stage), to.stage(stage));
}

void run_one(const Campaign& campaign, StageKind kind, Progress& progress, double before,
             double after) {
  const StageId stage{0, kind};
  stop_if_interrupted();
  progress.begin(std::string(name_of(kind)), before, after);
  static_cast<void>(run_stage(campaign, stage, progress));
  progress.end();
}

/// A charge like the campaign's, in flight and in contact, in the trial's folder.
void make_charge(Campaign campaign, Progress& progress) {
  campaign.mill.dem.mix_revolutions = flight_revolutions;
  campaign.mill.dem.mix_until_steady = false;
  progress.say(fmt::format("a new charge moves for {:g} revolutions first", flight_revolutions));
  run_one(campaign, StageKind::mesh, progress, 0.0, 0.0);
  run_one(campaign, StageKind::mix, progress, 0.0, share_before_trial);
}

}  // namespace

void add_options(CLI::App& verb, TuneOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--out", options.out,
                  "Folder of a campaign whose mixed charge is taken if it has one; by default "
                  "runs/NAME");
  add_ranks(verb, options.ranks);
}

void tune_verb(const TuneOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  check_liggghts_is_installed(mill.dem);
  const RunFolder source = run_folder_of(mill, options.out);
  const auto kept = campaign_up_to_mixing(source);
  std::optional<RunLock> lock;
  if (kept) {
    lock.emplace(source.lock());
    check_same_charge(mill, kept->campaign);
    check_outputs(kept->ledger, source.root);
  }
  const ScratchFolder scratch;
  const Campaign campaign{mill, {scratch.path()}, options.ranks.value_or(ranks_for(mill))};
  Progress progress(options.common.verbosity);
  if (kept) {
    progress.say(fmt::format("with the mixed charge of {}", source.root.string()));
    copy_stage(source, campaign.folder, StageKind::mesh);
    copy_stage(source, campaign.folder, StageKind::mix);
  } else {
    make_charge(campaign, progress);
  }
  run_one(campaign, StageKind::tune, progress, kept ? 0.0 : share_before_trial, 1.0);
  const fs::path file = campaign.folder.stage({0, StageKind::tune}) / stage_files::tuning;
  fmt::print("{}", options.common.form == OutputForm::json ? read_file(file)
                                                           : tuning_text(read_tuning(file)));
}

}  // namespace millwear::orchestrator
