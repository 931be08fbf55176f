#include "recorder/record/collision_spool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <utility>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "wear/record/collision_store.h"

namespace millwear::recorder {
namespace {

namespace fs = std::filesystem;
using wear::Collision;

constexpr std::size_t block = 8192;

fs::path spool_path(const fs::path& events, int rank) {
  return fs::path(events.string() + fmt::format(".rank{}", rank));
}

[[noreturn]] void refuse(const fs::path& path) {
  throw DiskError(fmt::format("{}: cannot be written or read ({}); is the disk full?",
                              path.string(), std::strerror(errno)));
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

/// The spools of all ranks, removed with this object.
struct Spools {
  const fs::path& events;
  int ranks;
  ~Spools() {
    for (int rank = 0; rank < ranks; ++rank) remove_quietly(spool_path(events, rank));
  }
};

/// Reads a spool from its start, a block at a time.
class SpoolReader {
 public:
  explicit SpoolReader(const fs::path& path)
      : path_(path), file_(std::fopen(path.c_str(), "rb"), &std::fclose) {
    if (!file_) refuse(path_);
    refill();
  }

  [[nodiscard]] bool at_end() const { return next_ == block_.size(); }
  [[nodiscard]] const Collision& front() const { return block_[next_]; }
  void pop() {
    if (++next_ == block_.size()) refill();
  }

 private:
  void refill() {
    block_.resize(block);
    block_.resize(std::fread(block_.data(), sizeof(Collision), block, file_.get()));
    if (std::ferror(file_.get()) != 0) refuse(path_);
    next_ = 0;
  }

  fs::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<Collision> block_;
  std::size_t next_ = 0;
};

/// Takes the collisions that ended first off the spools; the writer brings them into an order that
/// does not depend on which rank saw them.
std::vector<Collision> next_to_end(std::vector<SpoolReader>& spools) {
  double end = std::numeric_limits<double>::infinity();
  for (const auto& spool : spools)
    if (!spool.at_end()) end = std::min(end, spool.front().end);
  std::vector<Collision> together;
  for (auto& spool : spools)
    for (; !spool.at_end() && spool.front().end == end; spool.pop())
      together.push_back(spool.front());
  return together;
}

void merge(std::vector<SpoolReader>& spools, wear::CollisionWriter& writer) {
  for (auto ended = next_to_end(spools); !ended.empty(); ended = next_to_end(spools))
    writer.append(ended);
}

}  // namespace

CollisionSpool::CollisionSpool(const fs::path& events, int rank)
    : path_(spool_path(events, rank)), file_(std::fopen(path_.c_str(), "wb")) {
  if (file_ == nullptr) refuse(path_);
  buffer_.reserve(block);
}

CollisionSpool::~CollisionSpool() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  remove_quietly(path_);
}

void CollisionSpool::add(const Collision& collision) {
  buffer_.push_back(collision);
  if (buffer_.size() == block) flush();
}

void CollisionSpool::flush() {
  if (std::fwrite(buffer_.data(), sizeof(Collision), buffer_.size(), file_) != buffer_.size())
    refuse(path_);
  buffer_.clear();
}

void CollisionSpool::close() {
  flush();
  if (std::fflush(file_) != 0) refuse(path_);
  std::FILE* const file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) refuse(path_);
}

void remove_old_collisions(const fs::path& events, int ranks) {
  fs::remove(events);
  for (int rank = ranks; fs::remove(spool_path(events, rank)); ++rank) continue;
}

void publish_collisions(const fs::path& events, int ranks) {
  const Spools removed_at_the_end{events, ranks};
  publish_written(events, [&](const fs::path& beside) {
    std::vector<SpoolReader> spools;
    for (int rank = 0; rank < ranks; ++rank) spools.emplace_back(spool_path(events, rank));
    wear::CollisionWriter writer(beside);
    merge(spools, writer);
    writer.close();
  });
}

}  // namespace millwear::recorder
