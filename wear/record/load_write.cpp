#include "wear/record/load_write.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "wear/hdf5/hdf5_writer.h"

namespace millwear::wear {
namespace {

constexpr FileFormat format_of(std::string_view type) { return {type, load_format_version}; }

/// Whether HDF5 gives a chunk its place in the file as the dataset is closed. A larger one gets it
/// as soon as it is written.
bool fits_into_chunk_cache(const PackedDataset& packed) {
  constexpr hsize_t chunk_cache = 1 << 20;
  hsize_t size = sizeof(double);
  for (const auto extent : packed.sizes) size *= extent;
  return size <= chunk_cache;
}

/// Gives the dataset its index of chunks, before its attribute, by writing one value into the chunk
/// cache. `write_chunk` then drops that chunk.
void begin_storage(const Hdf5Writer& writer, const Handle& set, const PackedDataset& packed) {
  const std::vector<hsize_t> origin(packed.sizes.size(), 0);
  const std::vector<hsize_t> one(packed.sizes.size(), 1);
  const double value = 0.0;
  const Handle in_memory(H5Screate(H5S_SCALAR), H5Sclose, writer.failure());
  const Handle in_file(H5Dget_space(set.id()), H5Sclose, writer.failure());
  writer.check(H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, origin.data(), nullptr, one.data(),
                                   nullptr));
  writer.check(
      H5Dwrite(set.id(), H5T_NATIVE_DOUBLE, in_memory.id(), in_file.id(), H5P_DEFAULT, &value));
}

void write_chunk(const Hdf5Writer& writer, const Handle& set, const PackedDataset& packed) {
  const std::vector<hsize_t> origin(packed.sizes.size(), 0);
  writer.check(H5Dwrite_chunk(set.id(), H5P_DEFAULT, 0, origin.data(), packed.bytes.size(),
                              packed.bytes.data()));
}

/// The same bytes in the file as by `write_values`.
void write_packed(const Hdf5Writer& writer, std::int64_t group, const PackedDataset& packed) {
  Handle set = writer.new_set(group, packed.name, packed.sizes, NumberType::real64);
  if (fits_into_chunk_cache(packed)) {
    begin_storage(writer, set, packed);
    write_attribute(set.id(), "unit", packed.unit, writer.failure());
    write_chunk(writer, set, packed);
  } else {
    write_chunk(writer, set, packed);
    write_attribute(set.id(), "unit", packed.unit, writer.failure());
  }
  set.close(writer.failure());
}

/// What the file holds of a dataset that was written.
std::string chunk_of(const Hdf5Writer& writer, std::int64_t group, std::string_view name,
                     std::size_t rank) {
  const std::vector<hsize_t> origin(rank, 0);
  const Handle set(H5Dopen2(group, std::string(name).c_str(), H5P_DEFAULT), H5Dclose,
                   writer.failure());
  hsize_t size = 0;
  writer.check(H5Dget_chunk_storage_size(set.id(), origin.data(), &size));
  std::string bytes(size, '\0');
  std::uint32_t left_out = 0;
  writer.check(H5Dread_chunk(set.id(), H5P_DEFAULT, origin.data(), &left_out, bytes.data()));
  writer.check(left_out == 0 ? 0 : -1);
  return bytes;
}

/// Takes what is written as HDF5 stores it; the file is in memory and goes with this object.
class Packer {
 public:
  void write_values(std::int64_t, std::string_view name, std::string_view unit,
                    const Extents& sizes, const double* values) {
    memory_.write_values(memory_.root(), name, unit, sizes, values);
    packed_.push_back({std::string(name), std::string(unit), sizes,
                       chunk_of(memory_, memory_.root(), name, sizes.size())});
  }

  [[nodiscard]] std::vector<PackedDataset> packed() && { return std::move(packed_); }

 private:
  Hdf5Writer memory_{"a packed load in memory", format_of(many_loads)};
  std::vector<PackedDataset> packed_;
};

std::string joined_units() { return fmt::format("{}", fmt::join(measure_units, ", ")); }

void write_into(const Hdf5Writer& writer, const Handle& group, const ImpactSpectrum& spectrum) {
  const Eigen::VectorXd edges = energy_edges();
  writer.write_values(group.id(), "energy_edges", "J", {static_cast<hsize_t>(edges.size())},
                      edges.data());
  writer.write_matrix(group.id(), "normal_events", "1", spectrum.normal_events);
  writer.write_matrix(group.id(), "normal_energy", "J", spectrum.normal_energy);
  writer.write_matrix(group.id(), "shear_events", "1", spectrum.shear_events);
  writer.write_matrix(group.id(), "shear_energy", "J", spectrum.shear_energy);
  writer.write_matrix(group.id(), "unfinished", "1", spectrum.unfinished);
}

void write_into(const Hdf5Writer& writer, const Handle& group, const ChargeMotion& motion) {
  for (std::size_t part = 0; part < charge_part_count; ++part)
    writer.write_matrix(group.id(), fmt::format("{}_mass", charge_part_names[part]), "kg",
                        motion.census.row(static_cast<Eigen::Index>(part)).transpose());
  writer.write_matrix(group.id(), "plate_hit_mass", "kg", motion.plate.mass);
  writer.write_matrix(group.id(), "plate_hit_energy", "J", motion.plate.energy);
  writer.write_matrix(group.id(), "lifter_hit_mass", "kg", motion.lifter.mass);
  writer.write_matrix(group.id(), "lifter_hit_energy", "J", motion.lifter.energy);
}

/// Into an `Hdf5Writer` or a `Packer`.
template <class Sink>
void write_into(Sink& writer, std::int64_t group, const WallLoad& load) {
  const double rows = load.rows;
  const auto bins = static_cast<hsize_t>(load.bins());
  const Extents one{1};
  const Extents sizes{load.class_count, load.block_count, bins};
  writer.write_values(group, "slice_length", "m", one, &load.slice_length);
  writer.write_values(group, "rows", "1", one, &rows);
  writer.write_values(group, "duration", "s", one, &load.duration);
  writer.write_values(group, "bin_edges", "m", {bins + 1}, load.bin_edges.data());
  for (std::size_t m = 0; m < measure_count; ++m) {
    writer.write_values(group, measure_names[m], measure_units[m], sizes, load.values[m].data());
  }
  writer.write_values(group, "rejected", joined_units(), {measure_count}, load.rejected.data());
}

}  // namespace

void write_record(const std::filesystem::path& path, const LinerRecord& record) {
  Hdf5Writer writer(path, format_of(one_load));
  write_into(writer, writer.root(), record.load);
  const Handle angles = writer.new_group("charge_angles");
  writer.write_matrix(angles.id(), "contacts", "1", record.angles.contacts);
  writer.write_matrix(angles.id(), "normal_force", "N", record.angles.normal_force);
  write_into(writer, writer.new_group("liner_collisions"), record.spectrum);
  if (record.triangles.cols() > 0)
    writer.write_matrix(writer.root(), "triangles", joined_units(), record.triangles);
  if (record.pairs) {
    const Handle pairs = writer.new_group("particle_collisions");
    writer.write_number(pairs.id(), "duration", "s", record.pairs->duration);
    writer.write_number(pairs.id(), "normal_dissipation", "J", record.pairs->normal_dissipation);
    writer.write_number(pairs.id(), "shear_dissipation", "J", record.pairs->shear_dissipation);
    writer.write_number(pairs.id(), "rolling_dissipation", "J", record.pairs->rolling_dissipation);
    write_into(writer, pairs, record.pairs->spectrum);
  }
  if (record.motion) write_into(writer, writer.new_group("charge_motion"), *record.motion);
  if (record.polar) {
    const Handle polar = writer.new_group("polar_load");
    for (std::size_t m = 0; m < polar_measures.size(); ++m) {
      const auto measure = index_of(polar_measures[m]);
      writer.write_matrix(polar.id(), measure_names[measure], measure_units[measure],
                          record.polar->values[m]);
    }
  }
  if (record.goal) {
    const Handle goal = writer.new_group("goal");
    writer.write_number(goal.id(), "target_relative_error", "1", record.goal->target_error);
    writer.write_number(goal.id(), "peak_relative_error", "1", record.goal->peak_error);
  }
  writer.publish();
}

PackedLoad packed(const StoredLoad& stored) {
  Packer packer;
  write_into(packer, 0, stored.load);
  return {stored.cycle, std::move(packer).packed()};
}

void write_loads(const std::filesystem::path& path, std::span<const PackedLoad> loads) {
  Hdf5Writer writer(path, format_of(many_loads));
  for (const PackedLoad& load : loads) {
    const Handle group = writer.new_group(fmt::format("cycle_{:03}", load.cycle));
    for (const PackedDataset& set : load.datasets) write_packed(writer, group.id(), set);
  }
  writer.publish();
}

void write_loads(const std::filesystem::path& path, std::span<const StoredLoad> loads) {
  Hdf5Writer writer(path, format_of(many_loads));
  for (const StoredLoad& stored : loads) {
    const Handle group = writer.new_group(fmt::format("cycle_{:03}", stored.cycle));
    write_into(writer, group.id(), stored.load);
  }
  writer.publish();
}

}  // namespace millwear::wear
