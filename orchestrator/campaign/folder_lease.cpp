#include "orchestrator/campaign/folder_lease.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <fstream>
#include <iterator>
#include <mutex>
#include <utility>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr auto between_touches = std::chrono::seconds(20);
constexpr auto silent_for = std::chrono::minutes(5);

std::optional<std::string> text_of(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

void touch(const fs::path& file) { ::utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

/// A file of this process alone, beside the lease, so that its time is that of the same clock.
class Candidate {
 public:
  explicit Candidate(const fs::path& lease)
      : file_(fmt::format("{}.{}.{}", lease.string(), this_process().host, ::getpid())) {
    std::ofstream stream(file_);
    stream << written(this_process()) << std::flush;
    if (!stream)
      throw DiskError(
          fmt::format("{}: cannot be written: {}", file_.string(), std::strerror(errno)));
  }
  ~Candidate() { ::unlink(file_.c_str()); }
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  /// Makes it the lease, unless there is one. A link is atomic on every file system.
  [[nodiscard]] bool becomes(const fs::path& lease) const {
    return ::link(file_.c_str(), lease.c_str()) == 0;
  }

  /// How long a lease has not been touched; nothing where it is gone.
  [[nodiscard]] std::optional<std::chrono::seconds> silence_of(const fs::path& lease) const {
    touch(file_);
    struct stat mine = {};
    struct stat its = {};
    if (::stat(file_.c_str(), &mine) != 0 || ::stat(lease.c_str(), &its) != 0) return std::nullopt;
    return std::chrono::seconds(mine.st_mtime - its.st_mtime);
  }

 private:
  fs::path file_;
};

/// Moves away what a gone process has left, if it is still that.
void remove_left(const fs::path& lease, const std::string& left) {
  const fs::path aside =
      fmt::format("{}.left.{}.{}", lease.string(), this_process().host, ::getpid());
  if (::rename(lease.c_str(), aside.c_str()) != 0) return;
  // Another process may have taken it over in between: then it is given back.
  if (text_of(aside) != left) static_cast<void>(::link(aside.c_str(), lease.c_str()));
  ::unlink(aside.c_str());
}

}  // namespace

FolderLease::FolderLease(fs::path file) : file_(std::move(file)) {
  const Candidate candidate(file_);
  while (!candidate.becomes(file_)) {
    const auto text = text_of(file_);
    if (!text) continue;
    const auto holder = lock_holder_from(*text);
    const auto silence = candidate.silence_of(file_);
    const bool is_left = (holder && is_gone(*holder)) || (silence && *silence > silent_for);
    if (!is_left)
      throw Failure(
          ExitCode::locked,
          fmt::format("{}: the folder is in use by {}; wait for it, or give --out another "
                      "folder",
                      file_.parent_path().string(), spoken(holder)));
    remove_left(file_, *text);
  }
  touching_ = std::jthread([path = file_](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any woken;
    std::unique_lock lock(mutex);
    while (!woken.wait_for(lock, stop, between_touches, [] { return false; }) &&
           !stop.stop_requested())
      touch(path);
  });
}

FolderLease::~FolderLease() {
  touching_.request_stop();
  touching_.join();
  if (text_of(file_) == written(this_process())) ::unlink(file_.c_str());
}

std::optional<LockHolder> lease_holder(const fs::path& file) {
  const auto text = text_of(file);
  if (!text) return std::nullopt;
  const auto holder = lock_holder_from(*text);
  return holder && !is_gone(*holder) ? holder : std::nullopt;
}

}  // namespace millwear::orchestrator
