#include "orchestrator/campaign/folder_hashes.h"

#include <fmt/format.h>

#include <sstream>
#include <string>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/ledger.h"

namespace millwear::orchestrator {

namespace fs = std::filesystem;

void seal_folder(const fs::path& folder) {
  std::string hashes;
  for (const auto& file : fs::directory_iterator(folder)) {
    sync_path(file.path());
    hashes += fmt::format("{} {}\n", hash_of_file(file.path()), file.path().filename().string());
  }
  publish(folder / folder_hashes_file, hashes);
}

bool is_as_sealed(const fs::path& folder) {
  const fs::path list = folder / folder_hashes_file;
  if (!fs::exists(list)) return false;
  std::istringstream text(read_file(list));
  std::string hash;
  std::string name;
  while (text >> hash >> name)
    if (!fs::exists(folder / name) || hash_of_file(folder / name) != hash) return false;
  return true;
}

}  // namespace millwear::orchestrator
