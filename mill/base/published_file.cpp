#include "mill/base/published_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "mill/base/failure.h"

namespace millwear {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, std::string_view what, int reason) {
  throw DiskError(fmt::format("{}: cannot {} ({}); free some space or write to another folder",
                              path.string(), what, std::strerror(reason)));
}

/// An open file that is closed on the way out of an error; messages name it as `shown`.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags, const fs::path& shown)
      : path_(shown), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {
    if (descriptor_ < 0) fail(path_, "open", errno);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, "write", errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void sync_and_close() {
    if (::fsync(descriptor_) != 0) fail(path_, "sync", errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, "close", errno);
  }

 private:
  const fs::path& path_;
  int descriptor_;
};

/// A file beside its place; what is left of it goes with this object.
struct Beside {
  fs::path folder;
  fs::path path;

  explicit Beside(const fs::path& place)
      : folder(place.has_parent_path() ? place.parent_path() : fs::path(".")),
        path(folder /
             fmt::format(".{}.partial{}", place.stem().string(), place.extension().string())) {}
  ~Beside() { ::unlink(path.c_str()); }

  void take_place(const fs::path& place) const {
    if (::rename(path.c_str(), place.c_str()) != 0) fail(place, "rename into place", errno);
    sync_path(folder);
  }
};

}  // namespace

void publish(const fs::path& path, std::string_view bytes) {
  const Beside beside(path);
  OpenFile file(beside.path, O_WRONLY | O_CREAT | O_TRUNC, path);
  file.write(bytes);
  file.sync_and_close();
  beside.take_place(path);
}

void publish_written(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const Beside beside(path);
  write(beside.path);
  std::error_code missing;
  if (fs::file_size(beside.path, missing) == 0 || missing)
    throw DiskError(fmt::format("{}: came out empty; is the disk full?", path.string()));
  sync_path(beside.path);
  beside.take_place(path);
}

void sync_path(const fs::path& path) { OpenFile(path, O_RDONLY, path).sync_and_close(); }

}  // namespace millwear
