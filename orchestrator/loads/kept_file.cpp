#include "orchestrator/loads/kept_file.h"

#include <fmt/format.h>

#include "mill/base/published_file.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/ledger.h"

namespace millwear::orchestrator {
namespace {

constexpr int kept_version = 5;

std::string head_of(std::string_view key, std::string_view bytes) {
  return fmt::format("millwear kept {} {} {}\n", kept_version, key, hash_of_text(bytes));
}

}  // namespace

std::string kept_key(const Case& mill, std::string_view inputs) {
  return hash_of_text(fmt::format("{}\n{}\n{}\n{}", kept_version, program_version(),
                                  hash_of_text(locked_case_text(mill)), inputs));
}

std::filesystem::path kept_file(const RunFolder& folder, int cycle, std::string_view name) {
  return folder.stage({cycle, StageKind::wear}).parent_path() / "kept" / name;
}

void keep(const std::filesystem::path& file, std::string_view key, std::string_view bytes) {
  make_folder(file.parent_path());
  std::string text = head_of(key, bytes);
  text += bytes;
  publish(file, text);
}

std::optional<std::string> kept_bytes(const std::filesystem::path& file, std::string_view key) {
  if (!std::filesystem::is_regular_file(file)) return std::nullopt;
  std::string text = read_file(file);
  const auto end = text.find('\n');
  if (end == std::string::npos) return std::nullopt;
  const std::string_view bytes = std::string_view(text).substr(end + 1);
  if (std::string_view(text).substr(0, end + 1) != head_of(key, bytes)) return std::nullopt;
  text.erase(0, end + 1);
  return text;
}

}  // namespace millwear::orchestrator
