#include "orchestrator/campaign/ledger.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {
namespace {

constexpr int format_version = 1;
using nlohmann::json;

json as_json(const CampaignStart& start) {
  return {{"format_version", format_version},
          {"program", start.program},
          {"case_hash", start.case_hash},
          {"ranks", start.ranks},
          {"host", start.host}};
}

json as_json(const LedgerEntry& entry) {
  return {{"cycle", entry.stage.cycle},
          {"stage", name_of(entry.stage.kind)},
          {"outcome", name_of(entry.outcome)},
          {"outputs", entry.outputs},
          {"wall_seconds", entry.wall_seconds}};
}

LedgerEntry entry_from(const json& line) {
  return {{line.at("cycle").get<int>(), stage_kind_from(line.at("stage").get<std::string>())},
          outcome_from(line.at("outcome").get<std::string>()),
          line.at("outputs").get<std::map<std::string, std::string>>(),
          line.at("wall_seconds").get<double>()};
}

CampaignStart start_from(const json& line) {
  if (line.at("format_version").get<int>() != format_version)
    throw ResultRejected(fmt::format("format version {} and not {}; it is another program's",
                                     line.at("format_version").dump(), format_version));
  return {line.at("program").get<std::string>(), line.at("case_hash").get<std::string>(),
          line.at("ranks").get<int>(), line.at("host").get<std::string>()};
}

void cut_torn_line(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const auto whole = text.str().rfind('\n') + 1;
  if (whole != text.str().size()) std::filesystem::resize_file(file, whole);
}

std::string hexadecimal(XXH128_hash_t hash) {
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

const LedgerEntry* Ledger::find(const StageId& stage) const {
  for (const auto& entry : entries)
    if (entry.stage == stage) return &entry;
  return nullptr;
}

std::optional<Ledger> read_ledger(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::optional<Ledger> ledger;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (in.eof()) break;
    try {
      const json parsed = json::parse(line);
      if (!ledger)
        ledger = Ledger{start_from(parsed), {}};
      else
        ledger->entries.push_back(entry_from(parsed));
    } catch (const std::exception& problem) {
      throw ResultRejected(
          fmt::format("{}:{}: not a line of a ledger ({}); move the folder away and run again",
                      file.string(), number, problem.what()));
    }
  }
  return ledger;
}

void write_ledger(const std::filesystem::path& file, const Ledger& ledger) {
  std::string text = as_json(ledger.start).dump() + "\n";
  for (const auto& entry : ledger.entries) text += as_json(entry).dump() + "\n";
  publish(file, text);
}

void append_entry(const std::filesystem::path& file, const LedgerEntry& entry) {
  cut_torn_line(file);
  const std::string line = as_json(entry).dump() + "\n";
  const int fd = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  const ssize_t length = fd >= 0 ? ::write(fd, line.data(), line.size()) : -1;
  const bool short_write = length >= 0 && length < static_cast<ssize_t>(line.size());
  const bool written = length >= 0 && !short_write && ::fsync(fd) == 0;
  const int problem = short_write ? ENOSPC : errno;
  if (fd >= 0) ::close(fd);
  if (!written)
    throw DiskError(fmt::format("{}: cannot append: {}", file.string(), std::strerror(problem)));
}

std::string hash_of_text(std::string_view text) {
  return hexadecimal(XXH3_128bits(text.data(), text.size()));
}

std::string hash_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw DiskError(fmt::format("{}: cannot be read", file.string()));
  XXH3_state_t* const state = XXH3_createState();
  XXH3_128bits_reset(state);
  std::vector<char> piece(1 << 20);
  while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0)
    XXH3_128bits_update(state, piece.data(), static_cast<std::size_t>(in.gcount()));
  const XXH128_hash_t hash = XXH3_128bits_digest(state);
  XXH3_freeState(state);
  if (in.bad()) throw DiskError(fmt::format("{}: cannot be read to its end", file.string()));
  return hexadecimal(hash);
}

void check_outputs(const Ledger& ledger, const std::filesystem::path& root) {
  const RunFolder folder{root};
  for (const auto& entry : ledger.entries)
    for (const auto& [name, hash] : entry.outputs) {
      const auto file = folder.stage(entry.stage) / name;
      const bool there = std::filesystem::exists(file);
      if (!there || hash_of_file(file) != hash)
        throw ResultRejected(fmt::format(
            "{}: {} since it was published; put the file back, or run into another folder",
            file.string(), there ? "was changed" : "was removed"));
    }
}

}  // namespace millwear::orchestrator
