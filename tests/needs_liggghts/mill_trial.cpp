#include "tests/needs_liggghts/mill_trial.h"

#include "liggghts_inputs/charge_packing.h"
#include "liggghts_inputs/deck.h"
#include "mill/case_file.h"

namespace millwear::trial {
namespace {

namespace names = liggghts::file_names;

Stretch run(const Case& mill, const liggghts::StretchSteps& steps, meshgen::LinerMesh mesh,
            const std::filesystem::path& folder, liggghts::StretchKind kind, int cycle, int ranks) {
  write_text(
      folder / names::contact_model,
      liggghts::contact_model_deck(mill, steps, {"liner.stl", mesh.triangles.size()}, kind, cycle));
  auto dumps =
      run_deck(folder, ranks, {totals(mill).particles, mesh.triangles.size(), steps.total()});
  return {steps, std::move(mesh), std::move(dumps), log_of(folder)};
}

}  // namespace

Case small_mill() { return read_case(MILLWEAR_TRIAL_CASES "/small_mill.toml"); }

Stretch mix(const Case& mill, const liggghts::StretchSteps& steps,
            const std::filesystem::path& folder, int ranks) {
  auto mesh = write_liner_mesh(mill, mill.liner, folder);
  write_text(folder / names::charge, liggghts::charge_data_file(mill, liggghts::pack_charge(mill)));
  write_text(folder / names::deck, liggghts::mixing_deck(mill, steps));
  return run(mill, steps, std::move(mesh), folder, liggghts::StretchKind::mix, 0, ranks);
}

Stretch measure(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                const std::filesystem::path& folder, const std::string& previous, int cycle,
                int ranks) {
  auto mesh = write_liner_mesh(mill, liner, folder);
  write_text(folder / names::deck,
             liggghts::measuring_deck(mill, steps, liner, "../" + previous + "/" + names::restart));
  return run(mill, steps, std::move(mesh), folder, liggghts::StretchKind::measure, cycle, ranks);
}

}  // namespace millwear::trial
