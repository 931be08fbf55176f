#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/profile_csv.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/app/verbs.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/dem_run/stretch_stages.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

Case case_with_profile(const Command& command) {
  Case mill = read_case(command.case_file);
  if (command.profile) mill.liner = read_profile_csv(*command.profile, mill.liner.sector);
  return mill;
}

fs::path folder_for(const Command& command, const Case& mill, const char* what) {
  return command.out.empty() ? fs::path(what) / mill.name : command.out;
}

void print_folder(const Command& command, const fs::path& folder, const char* what) {
  if (command.form == OutputForm::json)
    fmt::print("{}\n", nlohmann::json{{"folder", folder.string()}}.dump());
  else
    fmt::print("{} in {}\n", what, folder.string());
}

}  // namespace

void mesh_verb(const Command& command) {
  const Case mill = case_with_profile(command);
  const fs::path folder = folder_for(command, mill, "mesh");
  make_folder(folder);
  write_mesh(mill, mill.liner, folder);
  print_folder(command, folder,
               "liner.stl, profile.csv, profile.step, profile.dxf and mesh.json are");
}

void deck_verb(const Command& command) {
  const Case mill = case_with_profile(command);
  Case untuned = mill;
  untuned.dem.tune = false;
  const Campaign campaign{
      untuned, {folder_for(command, mill, "deck")}, command.ranks.value_or(ranks_for(mill))};
  const auto folder_of = [&](StageKind kind) {
    const fs::path folder = campaign.folder.stage({0, kind});
    make_folder(folder);
    return folder;
  };
  write_mesh(mill, mill.liner, folder_of(StageKind::mesh));
  write_mixing_deck(campaign, 0, folder_of(StageKind::mix));
  write_measuring_deck(campaign, 0, folder_of(StageKind::dem));
  write_file(campaign.folder.locked_case(), locked_case_text(mill));
  print_folder(command, campaign.folder.root, "the decks (cycle_000/mix, then cycle_000/dem) are");
  if (command.form == OutputForm::json || mill.dem.contact_path != ContactPath::recorder) return;
  const auto mixing = mill.dem.mix_until_steady
                          ? mixing_arguments(mill)
                          : to_arguments(RunOptions{liggghts::file_names::deck});
  fmt::print(
      "cycle_000/mix is run by: mpirun -np {0} millwear-recorder {1}\n"
      "cycle_000/dem is measured by: mpirun -np {0} millwear-recorder {2}\n",
      campaign.ranks, fmt::join(mixing, " "), fmt::join(recorder_arguments(mill), " "));
}

}  // namespace millwear::orchestrator
