#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "wear/record/collision.h"

namespace millwear::wear {

/// Version and type of the file below; files of another version are refused.
inline constexpr int collision_format_version = 1;
inline constexpr std::string_view collision_file_type = "millwear collisions";

/// Writes collisions as they end to an HDF5 file: a dataset a column of `Collision`, in the order
/// of their end, then of the particle, so the file is the same on however many MPI ranks. Memory
/// does not grow with the file. Publishing it (beside, fsync, rename) is the caller's.
class CollisionWriter {
 public:
  /// Begins the file. Throws DiskError where that fails.
  explicit CollisionWriter(const std::filesystem::path& path);
  /// A file that was not closed has no number of collisions and is refused when read.
  ~CollisionWriter();
  CollisionWriter(const CollisionWriter&) = delete;
  CollisionWriter& operator=(const CollisionWriter&) = delete;

  /// Adds a block, in any order; but none of it may end before one of an earlier block: that throws
  /// a Failure (internal). Throws DiskError where the disk is full.
  void append(std::span<const Collision> collisions);

  /// Writes what is buffered and ends the file. Throws DiskError where any of it did not reach the
  /// disk.
  void close();

 private:
  class File;
  std::unique_ptr<File> file_;
};

/// Calls `take` for every collision of a file, in its order; memory does not grow with the file.
/// Throws DiskError where there is no file, ResultRejected where it holds no collisions, is of
/// another version, incomplete or damaged.
void for_each_collision(const std::filesystem::path& path,
                        const std::function<void(const Collision&)>& take);

}  // namespace millwear::wear
