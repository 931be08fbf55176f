#include "meshgen/published_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "mill/failure.h"

namespace millwear::meshgen {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::error_code& error) {
  throw DiskError(fmt::format("{}: cannot be written ({})", path.string(), error.message()));
}

void put_on_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    fail(path, {errno, std::generic_category()});
  }
  const int failed = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (failed != 0) {
    fail(path, {failed, std::generic_category()});
  }
}

/// Removes what is left of an unfinished file.
struct Leftover {
  std::filesystem::path path;
  ~Leftover() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

}  // namespace

void publish(const std::filesystem::path& path,
             const std::function<void(const std::filesystem::path& beside)>& write) {
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const Leftover beside{folder / (path.stem().string() + ".part" + path.extension().string())};
  write(beside.path);

  std::error_code error;
  const auto size = std::filesystem::file_size(beside.path, error);
  if (error) {
    fail(path, error);
  }
  if (size == 0) {
    throw DiskError(fmt::format("{}: came out empty; is the disk full?", path.string()));
  }
  put_on_disk(beside.path);
  std::filesystem::rename(beside.path, path, error);
  if (error) {
    fail(path, error);
  }
  put_on_disk(folder);
}

}  // namespace millwear::meshgen
