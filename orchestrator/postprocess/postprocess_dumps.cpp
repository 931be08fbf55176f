#include "orchestrator/postprocess/postprocess_dumps.h"

#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/postprocess/deck_mesh.h"
#include "orchestrator/postprocess/dump_load.h"
#include "orchestrator/postprocess/new_folder.h"
#include "wear/rate/load_rate.h"
#include "wear/rate/smoothing_error.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

KeptCycle kept(const wear::LoadRate& rate, const wear::Evolution& evolution) {
  KeptCycle cycle{rate.smoothed.moved_share, rate.raw.dot(rate.load.bin_widths()), {}};
  for (const auto& step : evolution.steps)
    cycle.steps.push_back(
        {step.duration, step.removed_area, step.accounted_area, step.fallen_area, step.profile});
  return cycle;
}

}  // namespace

PostprocessedDumps postprocess_dumps(const Case& mill, const LinerProfile& deck_liner,
                                     const HandRun& run, const std::filesystem::path& out,
                                     double longest) {
  NewFolder folder(out);
  Case turned = mill;
  turned.liner = deck_liner;
  const DumpLoad load = load_of_dumps(turned, triangles_of_deck(turned, run), run);
  const wear::LoadRate rate =
      wear::rate_of_load(mill.wear, mill.charge.classes, deck_liner, load.record.load);
  const std::vector<wear::TimedLoad> loads = {
      {0.0, deck_liner, rate.smoothed.rate, rate.by_block, wear::rolling_of(rate)}};
  const auto evolution = wear::evolve(loads, lifter_area(mill.liner), mill.campaign, longest);
  const KeptCycle cycle = kept(rate, evolution);
  PostprocessedDumps result{.first_step = load.outline.steps.front(),
                            .last_step = load.outline.steps.back(),
                            .samples = static_cast<long>(load.outline.steps.size()) - 1,
                            .contacts = load.outline.contacts,
                            .measured = load.record.load.duration,
                            .rejected_share = wear::rejected_share(load.record.load),
                            .section_rate = cycle.worn_by_load,
                            .peak_error = wear::peak_error(rate.smoothed),
                            .milled = 0.0,
                            .end = evolution.end,
                            .worn = deck_liner};
  for (const auto& step : evolution.steps) {
    result.milled += step.duration;
    result.worn = step.profile;
  }
  wear::write_record(folder.beside() / stage_files::load, load.record);
  write_cycle(folder.beside() / stage_files::steps, cycle);
  write_mesh(mill, result.worn, folder.beside());
  folder.publish();
  return result;
}

}  // namespace millwear::orchestrator
