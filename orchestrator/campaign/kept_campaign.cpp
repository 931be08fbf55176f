#include "orchestrator/campaign/kept_campaign.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"

namespace millwear::orchestrator {
namespace {

/// Throws ResultRejected unless the loads and steps are those that the ledger has.
void check_kept(Ledger ledger, const RunFolder& folder) {
  for (auto& entry : ledger.entries)
    std::erase_if(entry.outputs, [](const auto& output) {
      return output.first != stage_files::load && output.first != stage_files::steps;
    });
  check_outputs(ledger, folder.root);
}

Ledger ledger_in(const RunFolder& folder) {
  auto ledger = read_ledger(folder.ledger());
  if (!ledger || !std::filesystem::exists(folder.locked_case()))
    throw Failure(ExitCode::usage,
                  fmt::format("{}: no campaign is here; name one that `millwear run` has worked "
                              "in with --out",
                              folder.root.string()));
  if (ledger->find({0, StageKind::dem}) == nullptr)
    throw Failure(ExitCode::usage, fmt::format("{}: the campaign has no load yet (its first is "
                                               "measured in cycle 0 dem); let `millwear run` go "
                                               "on until then",
                                               folder.root.string()));
  return *ledger;
}

}  // namespace

KeptCampaign kept_campaign(const RunFolder& folder) {
  const Ledger ledger = ledger_in(folder);
  const Case run = read_case(folder.locked_case());
  check_kept(ledger, folder);
  return {{run, folder, ledger.start.ranks}, ledger};
}

}  // namespace millwear::orchestrator
