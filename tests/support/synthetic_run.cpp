#include "tests/support/synthetic_run.h"

#include <random>

#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/mill_frame.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "tests/support/example_case.h"
#include "tests/support/example_measurement.h"
#include "wear/evolve/load_carrier.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

constexpr int node_count = 240;
constexpr int steps_per_cycle = 5;

LinerProfile of_many_nodes(const LinerProfile& liner) {
  const auto lengths = arc_lengths(liner);
  LinerProfile fine{liner.sector, {liner.nodes.front()}};
  for (int i = 1; i < node_count - 1; ++i)
    fine.nodes.push_back(wear::place_at(liner, lengths, lengths.back() * i / (node_count - 1)));
  fine.nodes.push_back(liner.nodes.back());
  return fine;
}

wear::LinerRecord random_record(const Case& mill, const LinerProfile& liner, int cycle) {
  const auto lengths = arc_lengths(liner);
  std::mt19937 random(static_cast<unsigned>(cycle));
  std::uniform_real_distribution<double> any(0.0, 1.0);
  auto measurement = example_measurement(mill);
  measurement.particles = 60;
  wear::LoadAccumulator accumulator(liner, measurement);
  for (int sample = 0; sample < 100; ++sample) {
    WallContacts contacts{0.01 * sample, 0.0, {}};
    for (std::size_t particle = 1; particle <= 60; ++particle) {
      const auto spot = wear::place_at(liner, lengths, any(random) * lengths.back());
      const auto xz = to_mill(liner.sector, spot, 0, 0.0);
      WallContact contact{};
      contact.point = {xz.x(), 0.1, xz.y()};
      contact.into_wall = contact.point.normalized();
      contact.normal_force = 200.0 * any(random);
      contact.slip_speed = any(random);
      contact.path_speed = contact.slip_speed;
      contact.normal_speed = 0.1;
      contact.impact_speed = any(random);
      contact.particle_class = particle % 3;
      contact.particle = particle;
      contacts.contacts.push_back(contact);
    }
    accumulator.add(contacts);
  }
  return accumulator.finish();
}

Measured measurement() {
  Measured measured{};
  measured.power = 1000.0;
  measured.power_error = 10.0;
  for (int i = 1; i <= 100; ++i) {
    measured.power_times.push_back(0.01 * i);
    measured.power_series.push_back(1000.0 + i % 7);
  }
  measured.revolutions = 0.5;
  measured.peak_error = 0.05;
  return measured;
}

LedgerEntry entry_of(const Campaign& campaign, const StageId& stage,
                     const std::vector<std::string>& files) {
  LedgerEntry entry{stage, Outcome::go_on, {}, 1.0};
  for (const auto& file : files)
    entry.outputs[file] = hash_of_file(campaign.folder.stage(stage) / file);
  return entry;
}

}  // namespace

SyntheticRun synthetic_run(const std::filesystem::path& folder, int cycles) {
  Case mill = example_case();
  mill.liner = of_many_nodes(mill.liner);
  SyntheticRun run{{mill, {folder}, 1},
                   {{"a made-up program", hash_of_text(locked_case_text(mill)), 1, "nowhere"}, {}}};
  LinerProfile liner = mill.liner;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const StageId dem{cycle, StageKind::dem};
    const StageId wear{cycle, StageKind::wear};
    make_folder(run.campaign.folder.stage(dem));
    make_folder(run.campaign.folder.stage(wear));
    wear::write_record(run.campaign.folder.stage(dem) / stage_files::load,
                       random_record(mill, liner, cycle));
    write_measured(run.campaign.folder.stage(dem) / stage_files::measured, measurement());
    KeptCycle kept{0.03, 1e-12, {}};
    for (int step = 0; step < steps_per_cycle; ++step) {
      for (auto& node : liner.nodes)
        if (node.y() > 0.0) node.y() *= 1.0 - 0.1 / (cycles * steps_per_cycle);
      kept.steps.push_back({3.6e5, 1e-6, 1e-6, 0.0, liner});
    }
    write_cycle(run.campaign.folder.stage(wear) / stage_files::steps, kept);
    run.ledger.entries.push_back(
        entry_of(run.campaign, dem, {stage_files::load, stage_files::measured}));
    run.ledger.entries.push_back(entry_of(run.campaign, wear, {stage_files::steps}));
  }
  return run;
}

Ledger ledger_after(const Ledger& ledger, int cycle) {
  Ledger earlier{ledger.start, {}};
  for (const auto& entry : ledger.entries)
    if (entry.stage.cycle <= cycle) earlier.entries.push_back(entry);
  return earlier;
}

}  // namespace millwear::orchestrator
