#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

/// A campaign and what its folder says of it.
struct OpenCampaign {
  Campaign campaign;
  Ledger ledger;
};

/// The folder of a case's campaign: `out`, or runs/NAME where that is empty.
[[nodiscard]] RunFolder run_folder_of(const Case& mill, const std::filesystem::path& out);

/// The folder that `charge_from` names in a case that has it, absolute: it starts from the folder
/// of the case file.
[[nodiscard]] std::filesystem::path folder_of_charge(const Case& mill);

/// The case with `charge_from` as it is reached from the campaign's folder, so that both may be
/// moved together. As such it is kept there, and compared.
[[nodiscard]] Case as_kept(Case mill, const RunFolder& folder);

/// Who starts a campaign.
struct CampaignStarter {
  std::string program;  ///< name and version
  int ranks;            ///< of a campaign that begins
  std::string host;
};

/// The campaign of a case to be run: a new one, or the one in the folder as it goes on. A folder
/// belongs to a case once its first stage is published; before that any case may take it. A case
/// that only lowers limits goes on with the campaign. Nothing is written.
/// Throws InputError where the folder holds another case's campaign, Failure (usage) where `ranks`
/// are asked for and differ from the campaign's, and ResultRejected where a published file is not
/// as the ledger has it.
[[nodiscard]] OpenCampaign campaign_to_run(const Case& mill, const RunFolder& folder,
                                           const CampaignStarter& starter,
                                           std::optional<int> asked_ranks);

/// Writes the locked case and the ledger of a campaign that begins, or goes on to lower limits. The
/// case first: with it alone the campaign can still be taken up.
void keep_start(const OpenCampaign& opened);

/// The campaign of this very case in the folder. Throws Failure (usage) where there is none,
/// InputError where it is another case's.
[[nodiscard]] OpenCampaign campaign_of(const Case& mill, const RunFolder& folder);

/// The campaign in a folder with the case that it was run with, whatever that is, for what works on
/// its loads and steps; these are checked. Throws Failure (usage) where there is no campaign or no
/// load, ResultRejected where a load or the steps of a cycle are not as they were published.
[[nodiscard]] OpenCampaign campaign_with_loads(const RunFolder& folder);

/// The campaign in a folder up to its first mixing, for what only takes the charge; nothing where
/// it has not come to that. Its files are not checked: lock the folder first.
[[nodiscard]] std::optional<OpenCampaign> campaign_up_to_mixing(const RunFolder& folder);

/// The folder of the result tables of a campaign whose new liner is this case's: `results`, or the
/// folder itself where only small files were kept. Throws Failure (usage) where there are none,
/// InputError where the liner is another.
[[nodiscard]] std::filesystem::path results_of(const Case& mill, const RunFolder& folder);

}  // namespace millwear::orchestrator
