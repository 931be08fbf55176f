#include "wear/record/collision_store.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "wear/hdf5/hdf5_file.h"

namespace millwear::wear {
namespace {

constexpr FileFormat format{collision_file_type, collision_format_version};
constexpr unsigned deflate_level = 4;
constexpr std::size_t block_size = 8192;

enum class Number { real, natural, whole, flags };

struct Column {
  const char* name;
  const char* unit;
  Number number;
  std::size_t place;
};

constexpr std::array columns{
    Column{"start", "s", Number::real, offsetof(Collision, start)},
    Column{"end", "s", Number::real, offsetof(Collision, end)},
    Column{"arc_length", "m", Number::real, offsetof(Collision, arc_length)},
    Column{"axial_place", "m", Number::real, offsetof(Collision, axial_place)},
    Column{"impact_speed", "m/s", Number::real, offsetof(Collision, impact_speed)},
    Column{"impact_angle", "rad", Number::real, offsetof(Collision, impact_angle)},
    Column{"largest_normal_force", "N", Number::real, offsetof(Collision, largest_normal_force)},
    Column{"normal_dissipation", "J", Number::real, offsetof(Collision, normal_dissipation)},
    Column{"sliding_work", "J", Number::real, offsetof(Collision, sliding_work)},
    Column{"shear_dissipation", "J", Number::real, offsetof(Collision, shear_dissipation)},
    Column{"slip_distance", "m", Number::real, offsetof(Collision, slip_distance)},
    Column{"particle", "1", Number::natural, offsetof(Collision, particle)},
    Column{"particle_class", "1", Number::natural, offsetof(Collision, particle_class)},
    Column{"row", "1", Number::whole, offsetof(Collision, row)},
    Column{"unfinished", "1", Number::flags, offsetof(Collision, unfinished)},
};

std::size_t size_of(Number number) {
  switch (number) {
    case Number::real:
      return sizeof(double);
    case Number::natural:
      return sizeof(std::uint32_t);
    case Number::whole:
      return sizeof(std::int32_t);
    case Number::flags:
      break;
  }
  return sizeof(Unfinished);
}

hid_t in_memory(Number number) {
  switch (number) {
    case Number::real:
      return H5T_NATIVE_DOUBLE;
    case Number::natural:
      return H5T_NATIVE_UINT32;
    case Number::whole:
      return H5T_NATIVE_INT32;
    case Number::flags:
      break;
  }
  return H5T_NATIVE_UINT8;
}

hid_t in_file(Number number) {
  switch (number) {
    case Number::real:
      return H5T_IEEE_F64LE;
    case Number::natural:
      return H5T_STD_U32LE;
    case Number::whole:
      return H5T_STD_I32LE;
    case Number::flags:
      break;
  }
  return H5T_STD_U8LE;
}

bool earlier(const Collision& a, const Collision& b) {
  return std::tie(a.end, a.particle, a.start, a.arc_length) <
         std::tie(b.end, b.particle, b.start, b.arc_length);
}

}  // namespace

class CollisionWriter::File {
 public:
  explicit File(const std::filesystem::path& path)
      : failure_(unwritten_text(path)), file_(create(path)) {
    write_format(file_.id(), format, failure_);
    for (const Column& column : columns) sets_.push_back(new_set(column));
  }

  void append(std::span<const Collision> collisions) {
    std::vector<Collision> block(collisions.begin(), collisions.end());
    std::sort(block.begin(), block.end(), earlier);
    if (block.empty()) return;
    if (block.front().end < latest_end_) {
      throw Failure(ExitCode::internal,
                    fmt::format("a collision that ended at {} s comes after one of {} s",
                                block.front().end, latest_end_));
    }
    latest_end_ = block.back().end;
    for (std::size_t at = 0; at < block.size();) {
      const std::size_t taken = std::min(block_size - buffer_.size(), block.size() - at);
      const auto first = block.begin() + static_cast<std::ptrdiff_t>(at);
      buffer_.insert(buffer_.end(), first, first + static_cast<std::ptrdiff_t>(taken));
      at += taken;
      if (buffer_.size() == block_size) write_buffer();
    }
  }

  void close() {
    write_buffer();
    for (Handle& set : sets_) set.close(failure_);
    write_attribute(file_.id(), "collisions", static_cast<std::int64_t>(written_), failure_);
    check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL));
    file_.close(failure_);
  }

 private:
  void check(herr_t status) const {
    if (status < 0) throw DiskError(failure_);
  }

  [[nodiscard]] Handle create(const std::filesystem::path& path) const {
    const Handle options(H5Pcreate(H5P_FILE_CREATE), H5Pclose, failure_);
    check(H5Pset_obj_track_times(options.id(), false));
    const Handle access = unlocked_access(failure_);
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, options.id(), access.id()), H5Fclose, failure_};
  }

  [[nodiscard]] Handle new_set(const Column& column) const {
    const hsize_t none = 0;
    const hsize_t unlimited = H5S_UNLIMITED;
    const hsize_t chunk = block_size;
    const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose, failure_);
    const Handle options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, failure_);
    check(H5Pset_obj_track_times(options.id(), false));
    check(H5Pset_chunk(options.id(), 1, &chunk));
    check(H5Pset_shuffle(options.id()));
    check(H5Pset_deflate(options.id(), deflate_level));
    Handle set(H5Dcreate2(file_.id(), column.name, in_file(column.number), space.id(), H5P_DEFAULT,
                          options.id(), H5P_DEFAULT),
               H5Dclose, failure_);
    write_attribute(set.id(), "unit", column.unit, failure_);
    return set;
  }

  void write_buffer() {
    const hsize_t first = written_;
    const hsize_t count = buffer_.size();
    const hsize_t all = first + count;
    if (count == 0) return;
    const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose, failure_);
    std::vector<std::byte> values;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const std::size_t size = size_of(columns[c].number);
      values.resize(count * size);
      for (std::size_t i = 0; i < count; ++i)
        std::memcpy(&values[i * size],
                    reinterpret_cast<const std::byte*>(&buffer_[i]) + columns[c].place, size);
      check(H5Dset_extent(sets_[c].id(), &all));
      const Handle space(H5Dget_space(sets_[c].id()), H5Sclose, failure_);
      check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr));
      check(H5Dwrite(sets_[c].id(), in_memory(columns[c].number), memory.id(), space.id(),
                     H5P_DEFAULT, values.data()));
    }
    written_ = all;
    buffer_.clear();
  }

  std::string failure_;
  QuietErrors quiet_;
  Handle file_;
  std::vector<Handle> sets_;
  std::vector<Collision> buffer_;
  std::size_t written_ = 0;
  double latest_end_ = -std::numeric_limits<double>::infinity();
};

CollisionWriter::CollisionWriter(const std::filesystem::path& path)
    : file_(std::make_unique<File>(path)) {}
CollisionWriter::~CollisionWriter() = default;
void CollisionWriter::append(std::span<const Collision> collisions) { file_->append(collisions); }
void CollisionWriter::close() { file_->close(); }

namespace {

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : damaged_(damaged_text(path)),
        file_(open_to_read(path, format)),
        count_(read_attribute(file_.id(), "collisions", damaged_)) {
    for (const Column& column : columns) {
      sets_.push_back(owned(H5Dopen2(file_.id(), column.name, H5P_DEFAULT), H5Dclose));
      const Handle space = owned(H5Dget_space(sets_.back().id()), H5Sclose);
      check(H5Sget_simple_extent_ndims(space.id()) == 1 &&
            H5Sget_simple_extent_npoints(space.id()) == count_);
    }
  }

  void read(const std::function<void(const Collision&)>& take) const {
    std::vector<Collision> block;
    const auto all = static_cast<hsize_t>(count_);
    for (hsize_t first = 0; first < all; first += block.size()) {
      block.resize(std::min<hsize_t>(block_size, all - first));
      for (std::size_t c = 0; c < columns.size(); ++c) read_column(c, first, block);
      for (const Collision& collision : block) {
        check(collision.unfinished <= Unfinished::both);
        take(collision);
      }
    }
  }

 private:
  void check(bool fits) const {
    if (!fits) throw ResultRejected(damaged_);
  }

  [[nodiscard]] Handle owned(hid_t id, Handle::Closer closer) const {
    check(id >= 0);
    return {id, closer, damaged_};
  }

  void read_column(std::size_t c, hsize_t first, std::vector<Collision>& block) const {
    const hsize_t count = block.size();
    const std::size_t size = size_of(columns[c].number);
    std::vector<std::byte> values(count * size);
    const Handle memory = owned(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Handle space = owned(H5Dget_space(sets_[c].id()), H5Sclose);
    check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) >= 0);
    check(H5Dread(sets_[c].id(), in_memory(columns[c].number), memory.id(), space.id(), H5P_DEFAULT,
                  values.data()) >= 0);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(reinterpret_cast<std::byte*>(&block[i]) + columns[c].place, &values[i * size],
                  size);
  }

  std::string damaged_;
  QuietErrors quiet_;
  Handle file_;
  std::int64_t count_;
  std::vector<Handle> sets_;
};

}  // namespace

void for_each_collision(const std::filesystem::path& path,
                        const std::function<void(const Collision&)>& take) {
  Reader(path).read(take);
}

}  // namespace millwear::wear
