#include "orchestrator/stages/shared_stages.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/version.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/folder_hashes.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/charge_source.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/host_name.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr auto between_tries = std::chrono::milliseconds(200);
const WearMechanism any_law{.law = WearLaw::archard, .specific_wear_rate = 1.0};

/// The case as far as the DEM depends on it.
Case dem_case(const Campaign& campaign, const StageId& stage) {
  Case mill = case_of_stretch(campaign, stage);
  mill.name.clear();
  mill.dem.charge_from.reset();
  mill.dem.launcher = DemSettings{}.launcher;
  const auto reversals = mill.campaign.reversal_times;
  mill.campaign = {.height_limit = 0.0, .plate_limit = 0.0};
  mill.campaign.reversal_times = reversals;
  mill.feed_rate.reset();
  if (stage.kind == StageKind::mix) {
    const DemSettings standard;
    mill.dem.error_target.reset();
    mill.dem.measure_revolutions = standard.measure_revolutions;
    mill.dem.pair_revolutions = standard.pair_revolutions;
    mill.dem.keep_events = standard.keep_events;
    mill.wear = {};
    mill.wear.mechanisms = {any_law};
  }
  if (mill.dem.error_target) return mill;
  WearSettings recorded{};
  recorded.bins = mill.wear.bins;
  recorded.time_blocks = mill.wear.time_blocks;
  recorded.excess_speed = mill.wear.excess_speed;
  recorded.mechanisms = {any_law};
  mill.wear = recorded;
  return mill;
}

/// The restart file that a stage begins with, empty where it packs its charge.
fs::path charge_before(const Campaign& campaign, const StageId& stage) {
  const bool is_first = first_cycle_of_operation(campaign, stage.cycle) == stage.cycle;
  if (stage.kind == StageKind::dem)
    return campaign.folder.stage(is_first ? StageId{stage.cycle, StageKind::mix}
                                          : StageId{stage.cycle - 1, StageKind::dem}) /
           "charge.restart";
  const auto& charge_from = campaign.mill.dem.charge_from;
  if (stage.cycle > 0 || !charge_from) return {};
  return charge_source(campaign.mill, campaign.folder.root / *charge_from).restart;
}

std::string text_of(const LinerProfile& liner) {
  std::string text;
  for (const auto& node : liner.nodes) text += fmt::format("{} {}\n", node.x(), node.y());
  return text;
}

/// Holds a file for this process alone, waiting for others; on a file system without locks nobody
/// waits, and at worst two campaigns do the same work.
class WaitingLock {
 public:
  explicit WaitingLock(const fs::path& file)
      : fd_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
    if (fd_ < 0)
      throw DiskError(fmt::format("{}: cannot be opened: {}", file.string(), std::strerror(errno)));
    while (::flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      std::this_thread::sleep_for(between_tries);
      try {
        stop_if_interrupted();
      } catch (...) {
        ::close(fd_);
        throw;
      }
    }
  }
  ~WaitingLock() { ::close(fd_); }
  WaitingLock(const WaitingLock&) = delete;
  WaitingLock& operator=(const WaitingLock&) = delete;

 private:
  int fd_;
};

void link_or_copy(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::create_hard_link(from, to, failed);
  if (failed) fs::copy_file(from, to);
}

void take(const fs::path& stored, const fs::path& into) {
  for (const auto& file : fs::directory_iterator(stored))
    if (file.path().filename() != folder_hashes_file)
      link_or_copy(file.path(), into / file.path().filename());
}

/// Leaves the files of a folder in the store by one rename.
void leave(const fs::path& from, const fs::path& stored) {
  const fs::path partial =
      fmt::format("{}.{}.{}.partial", stored.string(), host_name(), ::getpid());
  fs::remove_all(partial);
  fs::remove_all(stored);
  make_folder(partial);
  for (const auto& file : fs::directory_iterator(from))
    link_or_copy(file.path(), partial / file.path().filename());
  seal_folder(partial);
  fs::rename(partial, stored);
  sync_path(stored.parent_path());
}

}  // namespace

std::string hash_of_dem(const Campaign& campaign, const StageId& stage) {
  const fs::path before = charge_before(campaign, stage);
  const std::string charge = before.empty() ? "" : hash_of_file(before);
  return hash_of_text(fmt::format("{}\n{}\n{} {}\n{}\n{}",
                                  locked_case_text(dem_case(campaign, stage)),
                                  text_of(dem_liner_of_cycle(campaign, stage.cycle)),
                                  name_of(stage), campaign.ranks, charge, program_version()));
}

void fill_shared(const fs::path& store, const std::string& hash, const fs::path& into,
                 const std::function<void()>& work) {
  make_folder(store);
  const fs::path stored = store / hash;
  const WaitingLock lock(store / (hash + ".lock"));
  if (is_as_sealed(stored)) return take(stored, into);
  work();
  leave(into, stored);
}

}  // namespace millwear::orchestrator
