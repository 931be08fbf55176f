#include "wear/record/load_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "wear/hdf5/hdf5_reader.h"

namespace millwear::wear {
namespace {

WallLoad read_from(const Hdf5Reader& reader, std::int64_t group) {
  WallLoad load{};
  load.slice_length = reader.read_number(group, "slice_length");
  load.rows = static_cast<int>(reader.read_number(group, "rows"));
  load.duration = reader.read_number(group, "duration");
  const auto edges = reader.read_values(group, "bin_edges", 1).values;
  load.bin_edges = Eigen::Map<const Eigen::VectorXd>(edges.data(), std::ssize(edges));
  for (std::size_t m = 0; m < measure_count; ++m) {
    const auto [sizes, values] = reader.read_values(group, measure_names[m], 3);
    if (m == 0) {
      load.class_count = sizes[0];
      load.block_count = sizes[1];
    }
    const bool fits = sizes[0] == load.class_count && sizes[1] == load.block_count &&
                      sizes[2] + 1 == edges.size();
    reader.require(fits);
    load.values[m] = Eigen::Map<const Eigen::MatrixXd>(
        values.data(), load.bins(), static_cast<Eigen::Index>(sizes[0] * sizes[1]));
  }
  const auto rejected = reader.read_values(group, "rejected", 1).values;
  reader.require(rejected.size() == measure_count);
  std::copy(rejected.begin(), rejected.end(), load.rejected.begin());
  return load;
}

ImpactSpectrum spectrum_from(const Hdf5Reader& reader, const Handle& group) {
  ImpactSpectrum spectrum{reader.read_matrix(group.id(), "normal_events"),
                          reader.read_matrix(group.id(), "normal_energy"),
                          reader.read_matrix(group.id(), "shear_events"),
                          reader.read_matrix(group.id(), "shear_energy"),
                          reader.read_matrix(group.id(), "unfinished").col(0)};
  reader.require(spectrum.normal_events.rows() == energy_classes);
  return spectrum;
}

ChargeMotion motion_from(const Hdf5Reader& reader, const Handle& group, std::size_t blocks) {
  ChargeMotion motion = no_charge_motion(blocks);
  const auto take = [&](const std::string& name, auto into) {
    const Eigen::MatrixXd found = reader.read_matrix(group.id(), name);
    reader.require(found.rows() == into.rows() && found.cols() == into.cols());
    into = found;
  };
  for (std::size_t part = 0; part < charge_part_count; ++part)
    take(fmt::format("{}_mass", charge_part_names[part]),
         motion.census.row(static_cast<Eigen::Index>(part)).transpose());
  using All = Eigen::Ref<Eigen::MatrixXd>;
  take("plate_hit_mass", All(motion.plate.mass));
  take("plate_hit_energy", All(motion.plate.energy));
  take("lifter_hit_mass", All(motion.lifter.mass));
  take("lifter_hit_energy", All(motion.lifter.energy));
  return motion;
}

PolarLoad polar_from(const Hdf5Reader& reader, const Handle& group) {
  PolarLoad polar;
  for (std::size_t m = 0; m < polar_measures.size(); ++m) {
    polar.values[m] = reader.read_matrix(group.id(), measure_names[index_of(polar_measures[m])]);
    reader.require(polar.values[m].rows() == polar.values[0].rows() &&
                   polar.values[m].cols() == polar_columns);
  }
  return polar;
}

PairRecord pairs_from(const Hdf5Reader& reader, const Handle& group) {
  return {reader.read_number(group.id(), "duration"), spectrum_from(reader, group),
          reader.read_number(group.id(), "normal_dissipation"),
          reader.read_number(group.id(), "shear_dissipation"),
          reader.read_number(group.id(), "rolling_dissipation")};
}

}  // namespace

LinerRecord read_record(const std::filesystem::path& path) {
  const Hdf5Reader reader(path, {one_load, load_format_version});
  LinerRecord record{};
  record.load = read_from(reader, reader.root());
  const Handle angles = reader.group("charge_angles");
  record.angles = {reader.read_matrix(angles.id(), "contacts"),
                   reader.read_matrix(angles.id(), "normal_force")};
  reader.require(record.angles.contacts.rows() == degrees_around);
  record.spectrum = spectrum_from(reader, reader.group("liner_collisions"));
  if (reader.has("triangles")) record.triangles = reader.read_matrix(reader.root(), "triangles");
  if (reader.has("particle_collisions"))
    record.pairs = pairs_from(reader, reader.group("particle_collisions"));
  if (reader.has("charge_motion"))
    record.motion = motion_from(reader, reader.group("charge_motion"), record.load.block_count);
  if (reader.has("polar_load")) record.polar = polar_from(reader, reader.group("polar_load"));
  if (reader.has("goal")) {
    const Handle goal = reader.group("goal");
    record.goal = {reader.read_number(goal.id(), "target_relative_error"),
                   reader.read_number(goal.id(), "peak_relative_error")};
  }
  return record;
}

WallLoad read_load(const std::filesystem::path& path) {
  const Hdf5Reader reader(path, {one_load, load_format_version});
  return read_from(reader, reader.root());
}

std::vector<StoredLoad> read_loads(const std::filesystem::path& path) {
  const Hdf5Reader reader(path, {many_loads, load_format_version});
  std::vector<StoredLoad> loads;
  for (const std::string& name : reader.names()) {
    const std::string number = name.substr(std::min(name.size(), name.find('_') + 1));
    loads.push_back({std::atoi(number.c_str()), read_from(reader, reader.group(name).id())});
  }
  return loads;
}

}  // namespace millwear::wear
