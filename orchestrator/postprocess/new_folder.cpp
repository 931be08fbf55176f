#include "orchestrator/postprocess/new_folder.h"

#include <fmt/format.h>

#include <utility>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

void check_is_free(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) ||
      (fs::is_directory(folder, ignored) && fs::is_empty(folder, ignored)))
    return;
  throw Failure(ExitCode::usage,
                fmt::format("--out {}: this exists already; name a new folder, or remove it",
                            folder.string()));
}

}  // namespace

NewFolder::NewFolder(fs::path folder)
    : folder_(fs::absolute(std::move(folder)).lexically_normal()) {
  if (!folder_.has_filename()) folder_ = folder_.parent_path();
  check_is_free(folder_);
  beside_ = folder_.parent_path() / fmt::format(".{}.partial", folder_.filename().string());
  fs::remove_all(beside_);
  make_folder(beside_);
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!beside_.empty()) fs::remove_all(beside_, ignored);
}

void NewFolder::publish() {
  for (const auto& file : fs::directory_iterator(beside_)) sync_path(file.path());
  sync_path(beside_);
  check_is_free(folder_);
  fs::rename(beside_, folder_);
  beside_.clear();
  sync_path(folder_.parent_path());
}

}  // namespace millwear::orchestrator
