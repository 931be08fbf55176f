#pragma once
#include <filesystem>
#include <initializer_list>
#include <string_view>

namespace millwear::orchestrator {

/// Every path that a verb is to write goes through one of these first; `option` is how the user
/// gave it, for the message. They throw Failure (usage).

/// Refuses a file that lies among a campaign's own (in a folder with a ledger or with a locked case
/// and results, or anywhere below one), that is one of the `inputs`, that is a folder, or whose
/// folder does not exist. An input whose path is empty is none.
void check_output_file(std::string_view option, const std::filesystem::path& file,
                       std::initializer_list<std::filesystem::path> inputs);

/// Refuses a folder for other files than a campaign's that lies in a campaign's folder or is one.
void check_output_folder(std::string_view option, const std::filesystem::path& folder);

/// Refuses a folder for a campaign that lies inside another campaign's.
void check_campaign_folder(std::string_view option, const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
