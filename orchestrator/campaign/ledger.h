#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// What a campaign was started with; a resumed one goes on with the same.
struct CampaignStart {
  std::string program;    ///< name and version
  std::string case_hash;  ///< of the locked case
  int ranks;
  std::string host;
};

/// One published stage.
struct LedgerEntry {
  StageId stage;
  Outcome outcome;
  std::map<std::string, std::string> outputs;  ///< file name in the stage's folder -> hash
  double wall_seconds;
};

/// The append-only record of a run folder: a line for the start and one for every stage that was
/// published. A stage without an entry has not happened.
struct Ledger {
  CampaignStart start;
  std::vector<LedgerEntry> entries;

  [[nodiscard]] const LedgerEntry* find(const StageId& stage) const;
};

/// Reads a ledger. A torn last line is dropped: its stage runs again. std::nullopt if there is no
/// file or it holds no whole line. Throws ResultRejected, with file:line, on any other damage and
/// on another format version.
[[nodiscard]] std::optional<Ledger> read_ledger(const std::filesystem::path& file);

/// Writes a whole ledger in one go; whatever stood there is replaced.
void write_ledger(const std::filesystem::path& file, const Ledger& ledger);

/// Appends one line and syncs it to the disk.
void append_entry(const std::filesystem::path& file, const LedgerEntry& entry);

/// Hash of a file's bytes (XXH3, 128 bits, in hexadecimal). Throws DiskError if it cannot be read.
[[nodiscard]] std::string hash_of_file(const std::filesystem::path& file);
[[nodiscard]] std::string hash_of_text(std::string_view text);

/// Throws ResultRejected, naming the file, unless every output of every entry is in its folder with
/// the hash the ledger has.
void check_outputs(const Ledger& ledger, const std::filesystem::path& root);

}  // namespace millwear::orchestrator
