#pragma once
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "wear/record/collision.h"

namespace millwear::recorder {

/// One rank's collisions on their way to the events file, in the order in which they ended: a file
/// beside it that is removed once all ranks' are merged, or with this object if it was not closed.
class CollisionSpool {
 public:
  /// Throws DiskError where the file cannot be made.
  CollisionSpool(const std::filesystem::path& events, int rank);
  ~CollisionSpool();
  CollisionSpool(const CollisionSpool&) = delete;
  CollisionSpool& operator=(const CollisionSpool&) = delete;

  void add(const wear::Collision& collision);
  /// All that was added is on its way to the disk. Throws DiskError where it is full.
  void close();

 private:
  void flush();

  std::filesystem::path path_;
  std::FILE* file_;
  std::vector<wear::Collision> buffer_;
};

/// Removes what a recording that was killed left: the events file and the spools of more ranks than
/// there are now.
void remove_old_collisions(const std::filesystem::path& events, int ranks);

/// Merges the closed spools of all ranks into the events file, ordered by end and then by particle,
/// in constant memory, and publishes it. The spools are removed, also where that fails.
void publish_collisions(const std::filesystem::path& events, int ranks);

}  // namespace millwear::recorder
