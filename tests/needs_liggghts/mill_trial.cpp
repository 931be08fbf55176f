#include "tests/needs_liggghts/mill_trial.h"

#include "liggghts_inputs/decks/charge_packing.h"
#include "liggghts_inputs/decks/deck.h"
#include "mill/case_file/case_file.h"

namespace millwear::trial {
namespace {

namespace names = liggghts::file_names;

/// Writes what both programs need and says what their log must show.
liggghts::StretchExpectation write_contact_model(const Case& mill,
                                                 const liggghts::StretchSteps& steps,
                                                 const meshgen::LinerMesh& mesh,
                                                 const std::filesystem::path& folder,
                                                 liggghts::StretchKind kind, int cycle) {
  write_text(folder / names::contact_model,
             liggghts::contact_model_deck(mill, steps, {"liner.stl", mesh.triangles.size()},
                                          {kind, cycle}));
  return {totals(mill).particles, mesh.triangles.size(), steps.total()};
}

Stretch run(const Case& mill, const liggghts::StretchSteps& steps, meshgen::LinerMesh mesh,
            const std::filesystem::path& folder, liggghts::StretchKind kind, int cycle, int ranks,
            const ChangeDeck& change) {
  const auto expected = write_contact_model(mill, steps, mesh, folder, kind, cycle);
  if (change) change(folder);
  auto dumps = run_deck(folder, ranks, expected);
  return {steps, std::move(mesh), std::move(dumps), log_of(folder)};
}

void write_measuring_deck(const Case& mill, const liggghts::StretchSteps& steps,
                          const LinerProfile& liner, const std::filesystem::path& folder,
                          const std::string& previous, int ranks) {
  write_text(
      folder / names::deck,
      liggghts::measuring_deck(mill, steps, liner, "../" + previous + "/" + names::restart, ranks));
}

}  // namespace

Case small_mill(ContactPath path) {
  Case mill = read_case(MILLWEAR_TRIAL_CASES "/small_mill.toml");
  mill.dem.contact_path = path;
  return mill;
}

Stretch mix(const Case& mill, const liggghts::StretchSteps& steps,
            const std::filesystem::path& folder, int ranks) {
  auto mesh = write_liner_mesh(mill, mill.liner, folder);
  write_text(folder / names::charge, liggghts::charge_data_file(mill, liggghts::pack_charge(mill)));
  write_text(folder / names::deck, liggghts::mixing_deck(mill, steps, {}, ranks));
  return run(mill, steps, std::move(mesh), folder, liggghts::StretchKind::mix, 0, ranks, {});
}

Stretch measure(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                const std::filesystem::path& folder, const std::string& previous, int cycle,
                int ranks, const ChangeDeck& change) {
  auto mesh = write_liner_mesh(mill, liner, folder);
  write_measuring_deck(mill, steps, liner, folder, previous, ranks);
  return run(mill, steps, std::move(mesh), folder, liggghts::StretchKind::measure, cycle, ranks,
             change);
}

Recording record(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                 const std::filesystem::path& folder, const std::string& previous, int ranks,
                 const ChangeDeck& change) {
  const auto mesh = write_liner_mesh(mill, liner, folder);
  write_measuring_deck(mill, steps, liner, folder, previous, ranks);
  const auto expected =
      write_contact_model(mill, steps, mesh, folder, liggghts::StretchKind::measure, 0);
  if (change) change(folder);
  return record_deck(mill, steps, liner, folder, ranks, expected);
}

}  // namespace millwear::trial
