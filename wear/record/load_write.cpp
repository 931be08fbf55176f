#include "wear/record/load_write.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wear/record/hdf5_file.h"

namespace millwear::wear {
namespace {

constexpr unsigned deflate_level = 4;

class Writer {
 public:
  Writer(const std::filesystem::path& path, std::string_view type)
      : path_(path), failure_(unwritten_text(path)), file_(create()) {
    write_format(root(), {type, load_format_version}, failure_);
  }

  [[nodiscard]] hid_t root() const { return file_.id(); }

  [[nodiscard]] Handle new_group(const std::string& name) const {
    Handle options = untimed(H5P_GROUP_CREATE);
    return {H5Gcreate2(root(), name.c_str(), H5P_DEFAULT, options.id(), H5P_DEFAULT), H5Gclose,
            failure_};
  }

  template <std::size_t rank>
  void write_values(hid_t group, std::string_view name, std::string_view unit,
                    const std::array<hsize_t, rank>& sizes, const double* values) const {
    Handle set = new_set(group, name, {sizes.begin(), sizes.end()});
    check(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    write_attribute(set.id(), "unit", unit, failure_);
    set.close(failure_);
  }

  /// The same bytes in the file as by `write_values`.
  void write_packed(hid_t group, const PackedDataset& packed) const {
    Handle set = new_set(group, packed.name, packed.sizes);
    if (fits_into_chunk_cache(packed)) {
      begin_storage(set, packed);
      write_attribute(set.id(), "unit", packed.unit, failure_);
      write_chunk(set, packed);
    } else {
      write_chunk(set, packed);
      write_attribute(set.id(), "unit", packed.unit, failure_);
    }
    set.close(failure_);
  }

  /// What the file holds of a dataset that was written.
  [[nodiscard]] std::string chunk_of(hid_t group, std::string_view name, std::size_t rank) const {
    const std::vector<hsize_t> origin(rank, 0);
    const Handle set(H5Dopen2(group, std::string(name).c_str(), H5P_DEFAULT), H5Dclose, failure_);
    hsize_t size = 0;
    check(H5Dget_chunk_storage_size(set.id(), origin.data(), &size));
    std::string bytes(size, '\0');
    std::uint32_t left_out = 0;
    check(H5Dread_chunk(set.id(), H5P_DEFAULT, origin.data(), &left_out, bytes.data()));
    check(left_out == 0 ? 0 : -1);
    return bytes;
  }

  void write_number(const Handle& group, std::string_view name, std::string_view unit,
                    double value) const {
    write_values(group.id(), name, unit, std::array<hsize_t, 1>{1}, &value);
  }

  /// As rows of the file's array: a column of the matrix each.
  void write_matrix(hid_t group, std::string_view name, std::string_view unit,
                    const Eigen::MatrixXd& values) const {
    const std::array<hsize_t, 2> sizes{static_cast<hsize_t>(values.cols()),
                                       static_cast<hsize_t>(values.rows())};
    write_values(group, name, unit, sizes, values.data());
  }

  /// Ends the file in memory and puts its bytes on the disk.
  void publish() {
    check(H5Fflush(root(), H5F_SCOPE_LOCAL));
    const ssize_t size = H5Fget_file_image(root(), nullptr, 0);
    check(size < 0 ? -1 : 0);
    std::vector<char> image(static_cast<std::size_t>(size));
    check(H5Fget_file_image(root(), image.data(), image.size()) < 0 ? -1 : 0);
    file_.close(failure_);
    std::ofstream disk(path_, std::ios::binary | std::ios::trunc);
    disk.write(image.data(), std::ssize(image));
    disk.close();
    check(disk ? 0 : -1);
  }

 private:
  void check(herr_t status) const {
    if (status < 0) throw DiskError(failure_);
  }

  /// An empty dataset of one chunk, shuffled and deflated.
  [[nodiscard]] Handle new_set(hid_t group, std::string_view name,
                               const std::vector<hsize_t>& sizes) const {
    const auto rank = static_cast<int>(sizes.size());
    Handle space(H5Screate_simple(rank, sizes.data(), nullptr), H5Sclose, failure_);
    Handle options = untimed(H5P_DATASET_CREATE);
    check(H5Pset_chunk(options.id(), rank, sizes.data()));
    check(H5Pset_shuffle(options.id()));
    check(H5Pset_deflate(options.id(), deflate_level));
    return {H5Dcreate2(group, std::string(name).c_str(), H5T_IEEE_F64LE, space.id(), H5P_DEFAULT,
                       options.id(), H5P_DEFAULT),
            H5Dclose, failure_};
  }

  /// Whether HDF5 gives a chunk its place in the file as the dataset is closed. A larger one gets
  /// it as soon as it is written.
  [[nodiscard]] static bool fits_into_chunk_cache(const PackedDataset& packed) {
    constexpr hsize_t chunk_cache = 1 << 20;
    hsize_t size = sizeof(double);
    for (const auto extent : packed.sizes) size *= extent;
    return size <= chunk_cache;
  }

  /// Gives the dataset its index of chunks, before its attribute, by writing one value into the
  /// chunk cache. `write_chunk` then drops that chunk.
  void begin_storage(const Handle& set, const PackedDataset& packed) const {
    const std::vector<hsize_t> origin(packed.sizes.size(), 0);
    const std::vector<hsize_t> one(packed.sizes.size(), 1);
    const double value = 0.0;
    const Handle in_memory(H5Screate(H5S_SCALAR), H5Sclose, failure_);
    const Handle in_file(H5Dget_space(set.id()), H5Sclose, failure_);
    check(H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, origin.data(), nullptr, one.data(),
                              nullptr));
    check(H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, in_memory.id(), in_file.id(), H5P_DEFAULT, &value));
  }

  void write_chunk(const Handle& set, const PackedDataset& packed) const {
    const std::vector<hsize_t> origin(packed.sizes.size(), 0);
    check(H5Dwrite_chunk(set.id(), H5P_DEFAULT, 0, origin.data(), packed.bytes.size(),
                         packed.bytes.data()));
  }

  [[nodiscard]] Handle untimed(hid_t kind) const {
    Handle options(H5Pcreate(kind), H5Pclose, failure_);
    check(H5Pset_obj_track_times(options.id(), false));
    return options;
  }

  [[nodiscard]] Handle create() const {
    constexpr std::size_t growth = 1 << 20;
    Handle options = untimed(H5P_FILE_CREATE);
    const Handle access = unlocked_access(failure_);
    check(H5Pset_fapl_core(access.id(), growth, false));
    return {H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, options.id(), access.id()), H5Fclose, failure_};
  }

  std::filesystem::path path_;
  std::string failure_;
  QuietErrors quiet_;
  Handle file_;
};

/// Takes what is written as HDF5 stores it; the file is in memory and goes with this object.
class Packer {
 public:
  template <std::size_t rank>
  void write_values(hid_t, std::string_view name, std::string_view unit,
                    const std::array<hsize_t, rank>& sizes, const double* values) {
    memory_.write_values(memory_.root(), name, unit, sizes, values);
    packed_.push_back({std::string(name),
                       std::string(unit),
                       {sizes.begin(), sizes.end()},
                       memory_.chunk_of(memory_.root(), name, rank)});
  }

  [[nodiscard]] std::vector<PackedDataset> packed() && { return std::move(packed_); }

 private:
  Writer memory_{"a packed load in memory", many_loads};
  std::vector<PackedDataset> packed_;
};

std::string joined_units() { return fmt::format("{}", fmt::join(measure_units, ", ")); }

void write_into(const Writer& writer, const Handle& group, const ImpactSpectrum& spectrum) {
  const Eigen::VectorXd edges = energy_edges();
  writer.write_values(group.id(), "energy_edges", "J",
                      std::array<hsize_t, 1>{static_cast<hsize_t>(edges.size())}, edges.data());
  writer.write_matrix(group.id(), "normal_events", "1", spectrum.normal_events);
  writer.write_matrix(group.id(), "normal_energy", "J", spectrum.normal_energy);
  writer.write_matrix(group.id(), "shear_events", "1", spectrum.shear_events);
  writer.write_matrix(group.id(), "shear_energy", "J", spectrum.shear_energy);
  writer.write_matrix(group.id(), "unfinished", "1", spectrum.unfinished);
}

void write_into(const Writer& writer, const Handle& group, const ChargeMotion& motion) {
  for (std::size_t part = 0; part < charge_part_count; ++part)
    writer.write_matrix(group.id(), fmt::format("{}_mass", charge_part_names[part]), "kg",
                        motion.census.row(static_cast<Eigen::Index>(part)).transpose());
  writer.write_matrix(group.id(), "plate_hit_mass", "kg", motion.plate.mass);
  writer.write_matrix(group.id(), "plate_hit_energy", "J", motion.plate.energy);
  writer.write_matrix(group.id(), "lifter_hit_mass", "kg", motion.lifter.mass);
  writer.write_matrix(group.id(), "lifter_hit_energy", "J", motion.lifter.energy);
}

/// Into a `Writer` or a `Packer`.
template <class Sink>
void write_into(Sink& writer, hid_t group, const WallLoad& load) {
  const double rows = load.rows;
  const auto bins = static_cast<hsize_t>(load.bins());
  const std::array<hsize_t, 1> one{1};
  const std::array<hsize_t, 1> edges{bins + 1};
  const std::array<hsize_t, 1> rejected{measure_count};
  const std::array<hsize_t, 3> sizes{load.class_count, load.block_count, bins};
  writer.write_values(group, "slice_length", "m", one, &load.slice_length);
  writer.write_values(group, "rows", "1", one, &rows);
  writer.write_values(group, "duration", "s", one, &load.duration);
  writer.write_values(group, "bin_edges", "m", edges, load.bin_edges.data());
  for (std::size_t m = 0; m < measure_count; ++m) {
    writer.write_values(group, measure_names[m], measure_units[m], sizes, load.values[m].data());
  }
  writer.write_values(group, "rejected", joined_units(), rejected, load.rejected.data());
}

}  // namespace

void write_record(const std::filesystem::path& path, const LinerRecord& record) {
  Writer writer(path, one_load);
  write_into(writer, writer.root(), record.load);
  const Handle angles = writer.new_group("charge_angles");
  writer.write_matrix(angles.id(), "contacts", "1", record.angles.contacts);
  writer.write_matrix(angles.id(), "normal_force", "N", record.angles.normal_force);
  write_into(writer, writer.new_group("liner_collisions"), record.spectrum);
  if (record.triangles.cols() > 0)
    writer.write_matrix(writer.root(), "triangles", joined_units(), record.triangles);
  if (record.pairs) {
    const Handle pairs = writer.new_group("particle_collisions");
    writer.write_number(pairs, "duration", "s", record.pairs->duration);
    writer.write_number(pairs, "normal_dissipation", "J", record.pairs->normal_dissipation);
    writer.write_number(pairs, "shear_dissipation", "J", record.pairs->shear_dissipation);
    writer.write_number(pairs, "rolling_dissipation", "J", record.pairs->rolling_dissipation);
    write_into(writer, pairs, record.pairs->spectrum);
  }
  if (record.motion) write_into(writer, writer.new_group("charge_motion"), *record.motion);
  if (record.goal) {
    const Handle goal = writer.new_group("goal");
    writer.write_number(goal, "target_relative_error", "1", record.goal->target_error);
    writer.write_number(goal, "peak_relative_error", "1", record.goal->peak_error);
  }
  writer.publish();
}

PackedLoad packed(const StoredLoad& stored) {
  Packer packer;
  write_into(packer, 0, stored.load);
  return {stored.cycle, std::move(packer).packed()};
}

void write_loads(const std::filesystem::path& path, std::span<const PackedLoad> loads) {
  Writer writer(path, many_loads);
  for (const PackedLoad& load : loads) {
    const Handle group = writer.new_group(fmt::format("cycle_{:03}", load.cycle));
    for (const PackedDataset& set : load.datasets) writer.write_packed(group.id(), set);
  }
  writer.publish();
}

void write_loads(const std::filesystem::path& path, std::span<const StoredLoad> loads) {
  Writer writer(path, many_loads);
  for (const StoredLoad& stored : loads) {
    const Handle group = writer.new_group(fmt::format("cycle_{:03}", stored.cycle));
    write_into(writer, group.id(), stored.load);
  }
  writer.publish();
}

}  // namespace millwear::wear
