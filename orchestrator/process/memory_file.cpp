#include "orchestrator/process/memory_file.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

[[noreturn]] void fail(const std::string& subject) {
  throw DiskError(fmt::format("{}, as a file in memory: {}", subject, std::strerror(errno)));
}

}  // namespace

MemoryFile::MemoryFile(std::string subject)
    : subject_(std::move(subject)), descriptor_(::memfd_create("millwear", MFD_CLOEXEC)) {
  if (descriptor_ < 0) fail(subject_);
}

MemoryFile::MemoryFile(std::string subject, std::string_view content)
    : MemoryFile(std::move(subject)) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor_, content.data(), content.size());
    if (written < 0) fail(subject_);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  ::lseek(descriptor_, 0, SEEK_SET);
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

std::filesystem::path MemoryFile::path() const {
  return fmt::format("/proc/{}/fd/{}", ::getpid(), descriptor_);
}

std::string MemoryFile::content() const {
  std::string text(static_cast<std::size_t>(::lseek(descriptor_, 0, SEEK_END)), '\0');
  if (::pread(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    fail(subject_);
  return text;
}

}  // namespace millwear::orchestrator
