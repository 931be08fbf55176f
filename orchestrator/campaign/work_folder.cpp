#include "orchestrator/campaign/work_folder.h"

#include <fmt/format.h>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/ledger.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// A campaign's own folder on the scratch disk.
fs::path scratch_of(const Campaign& campaign) {
  constexpr std::size_t digits = 16;
  const std::string place = fs::absolute(campaign.folder.root).lexically_normal().string();
  return *campaign.scratch / fmt::format("millwear-{}", hash_of_text(place).substr(0, digits));
}

void link_to(const fs::path& target, const fs::path& link) {
  if (fs::symlink_status(link).type() == fs::file_type::not_found)
    fs::create_symlink(fs::absolute(target), link);
}

/// Links to what a cycle has published, which a deck reads by paths from its own folder.
void link_cycle(const fs::path& cycle, const fs::path& scratch) {
  if (!fs::exists(cycle)) return;
  make_folder(scratch / cycle.filename());
  for (const auto& entry : fs::directory_iterator(cycle))
    if (entry.path().extension() != ".partial")
      link_to(entry.path(), scratch / cycle.filename() / entry.path().filename());
}

}  // namespace

fs::path begin_work(const Campaign& campaign, const fs::path& partial) {
  fs::path work = partial;
  if (campaign.scratch) {
    const fs::path scratch = scratch_of(campaign);
    make_folder(scratch);
    link_to(campaign.folder.locked_case(), scratch / campaign.folder.locked_case().filename());
    for (const auto& entry : fs::directory_iterator(campaign.folder.root))
      if (entry.path().filename().string().starts_with("cycle_")) link_cycle(entry.path(), scratch);
    work = scratch / partial.parent_path().filename() / partial.filename();
  }
  fs::remove_all(work);
  make_folder(work);
  return work;
}

void end_work(const fs::path& work, const fs::path& partial) {
  if (work == partial) return;
  fs::remove_all(partial);
  make_folder(partial);
  std::error_code failed;
  fs::copy(work, partial, fs::copy_options::recursive, failed);
  if (failed)
    throw DiskError(fmt::format("{}: cannot be copied to {}: {}", work.string(), partial.string(),
                                failed.message()));
  fs::remove_all(work);
}

void leave_scratch(const Campaign& campaign) {
  std::error_code ignored;
  if (campaign.scratch) fs::remove_all(scratch_of(campaign), ignored);
}

}  // namespace millwear::orchestrator
