#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "mill/base/failure.h"

namespace millwear::wear {

/// Owns one HDF5 identifier. `close` is where a failed write shows, so writers call it and look;
/// the destructor is for the way out of an error only.
class Handle {
 public:
  using Closer = int (*)(std::int64_t);
  Handle(std::int64_t id, Closer closer, const std::string& failure) : id_(id), closer_(closer) {
    if (id < 0) throw DiskError(failure);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }

  [[nodiscard]] std::int64_t id() const { return id_; }

  void close(const std::string& failure) {
    if (closer_(std::exchange(id_, -1)) < 0) throw DiskError(failure);
  }

 private:
  std::int64_t id_;
  Closer closer_;
};

/// HDF5 keeps its error stack off stderr while this lives. From the first on it does not tidy up at
/// the program's exit either: it would crash there on a file that the disk had no room for.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  int (*function_)(std::int64_t, void*);
  void* data_;
};

/// What a file says of itself, as the attributes `type` and `format_version` of its root.
struct FileFormat {
  std::string_view type;
  int version;
};

/// What is wrong with a file that cannot be read.
[[nodiscard]] std::string damaged_text(const std::filesystem::path& path);
/// What is wrong where a file cannot be written.
[[nodiscard]] std::string unwritten_text(const std::filesystem::path& path);

/// Throws DiskError with `failure` where the attribute cannot be written.
void write_attribute(std::int64_t owner, const char* name, std::string_view text,
                     const std::string& failure);
void write_attribute(std::int64_t owner, const char* name, std::int64_t number,
                     const std::string& failure);
void write_format(std::int64_t file, const FileFormat& format, const std::string& failure);

/// How files are opened: without HDF5's own locks, which a file system may lack. Files are complete
/// before anybody reads them, and a folder has a lock of its own. Throws DiskError with `failure`.
[[nodiscard]] Handle unlocked_access(const std::string& failure);

/// Opens a file to read. Throws DiskError where there is none, ResultRejected where it is of
/// another type or version, or damaged.
[[nodiscard]] Handle open_to_read(const std::filesystem::path& path, const FileFormat& format);

/// Throws ResultRejected with `damaged` where there is no such attribute, or no number in it.
[[nodiscard]] std::int64_t read_attribute(std::int64_t owner, const char* name,
                                          const std::string& damaged);

}  // namespace millwear::wear
