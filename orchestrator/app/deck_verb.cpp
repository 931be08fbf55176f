#include "orchestrator/app/deck_verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/app/liner_choice.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/stretch/stretch_decks.h"

namespace millwear::orchestrator {

void add_options(CLI::App& verb, DeckOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--out", options.out, "Folder of the files; by default deck/NAME");
  add_worn_profile(verb, options.profile);
  add_ranks(verb, options.ranks);
}

void deck_verb(const DeckOptions& options) {
  const Case mill = case_with_profile(options.common, options.profile);
  const auto folder = folder_or_default(options.out, "deck", mill);
  check_output_folder("--out", folder);
  Case untuned = mill;
  untuned.dem.tune = false;
  // A path from the folder of the case is none from the folder of the decks.
  if (mill.dem.charge_from) untuned.dem.charge_from = folder_of_charge(mill);
  const Campaign campaign =
      as_operated({untuned, {folder}, options.ranks.value_or(ranks_for(mill))}, 0);
  const auto folder_of = [&](StageKind kind) {
    const auto stage_folder = campaign.folder.stage({0, kind});
    make_folder(stage_folder);
    return stage_folder;
  };
  write_mesh(mill, mill.liner, folder_of(StageKind::mesh));
  write_mixing_deck(campaign, 0, folder_of(StageKind::mix));
  write_measuring_deck(campaign, 0, folder_of(StageKind::dem));
  write_file(campaign.folder.locked_case(), locked_case_text(untuned));
  print_folder(options.common, campaign.folder.root,
               "the decks (cycle_000/mix, then cycle_000/dem) are");
  if (options.common.form == OutputForm::json || mill.dem.contact_path != ContactPath::recorder)
    return;
  const auto mixing =
      mill.dem.mix_until_steady
          ? mixing_arguments(mill, campaign.ranks)
          : to_arguments(DeckRunOptions{liggghts::file_names::deck,
                                        liggghts::columns_to_balance(mill, campaign.ranks)});
  fmt::print(
      "cycle_000/mix is run by: mpirun -np {0} millwear-recorder {1}\n"
      "cycle_000/dem is measured by: mpirun -np {0} millwear-recorder {2}\n",
      campaign.ranks, fmt::join(mixing, " "),
      fmt::join(recorder_arguments(mill, campaign.ranks), " "));
}

}  // namespace millwear::orchestrator
