#include "orchestrator/results/published_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "mill/failure.h"

namespace millwear::orchestrator {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what, int reason) {
  throw DiskError(fmt::format("{}: cannot {} ({}); free some space or write to another folder",
                              path.string(), what, std::strerror(reason)));
}

int opened(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC, 0644);
  if (descriptor < 0) fail(path, "open", errno);
  return descriptor;
}

void write_all(int descriptor, const std::filesystem::path& path, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

void sync_and_close(Descriptor& file, const std::filesystem::path& path) {
  if (::fsync(file.number) != 0) fail(path, "sync", errno);
  if (::close(std::exchange(file.number, -1)) != 0) fail(path, "close", errno);
}

void write_beside(const std::filesystem::path& partial, std::string_view bytes) {
  Descriptor file{opened(partial, O_WRONLY | O_CREAT | O_TRUNC)};
  write_all(file.number, partial, bytes);
  sync_and_close(file, partial);
}

}  // namespace

void publish(const std::filesystem::path& path, std::string_view bytes) {
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const auto partial = folder / fmt::format(".{}.partial", path.filename().string());
  try {
    write_beside(partial, bytes);
    if (::rename(partial.c_str(), path.c_str()) != 0) fail(path, "rename into place", errno);
  } catch (const DiskError&) {
    ::unlink(partial.c_str());
    throw;
  }
  Descriptor directory{opened(folder, O_RDONLY | O_DIRECTORY)};
  sync_and_close(directory, folder);
}

}  // namespace millwear::orchestrator
