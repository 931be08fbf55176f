#include "wear/record/load_read.h"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "wear/record/hdf5_file.h"

namespace millwear::wear {
namespace {

class Reader {
 public:
  Reader(const std::filesystem::path& path, std::string_view type)
      : damaged_(damaged_text(path)), file_(open_to_read(path, {type, load_format_version})) {}

  [[nodiscard]] hid_t root() const { return file_.id(); }

  [[nodiscard]] Handle group(const std::string& name) const {
    return owned(H5Gopen2(root(), name.c_str(), H5P_DEFAULT), H5Gclose);
  }

  [[nodiscard]] std::vector<std::string> names() const {
    H5G_info_t info{};
    check(H5Gget_info(root(), &info));
    std::vector<std::string> found;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      std::array<char, 64> name{};
      check(H5Lget_name_by_idx(root(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(),
                               H5P_DEFAULT) < 0
                ? -1
                : 0);
      found.emplace_back(name.data());
    }
    return found;
  }

  struct Values {
    std::vector<hsize_t> sizes;
    std::vector<double> values;
  };

  [[nodiscard]] Values read_values(hid_t group, std::string_view name, int rank) const {
    Handle set = owned(H5Dopen2(group, std::string(name).c_str(), H5P_DEFAULT), H5Dclose);
    Handle space = owned(H5Dget_space(set.id()), H5Sclose);
    if (H5Sget_simple_extent_ndims(space.id()) != rank) check(-1);
    Values found{std::vector<hsize_t>(static_cast<std::size_t>(rank)), {}};
    check(H5Sget_simple_extent_dims(space.id(), found.sizes.data(), nullptr));
    found.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
    check(H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, found.values.data()));
    return found;
  }

  [[nodiscard]] double read_number(hid_t group, std::string_view name) const {
    const Values found = read_values(group, name, 1);
    check(found.values.size() == 1 ? 0 : -1);
    return found.values.front();
  }

  [[nodiscard]] Eigen::MatrixXd read_matrix(hid_t group, std::string_view name) const {
    const auto [sizes, values] = read_values(group, name, 2);
    return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(sizes[1]),
                                             static_cast<Eigen::Index>(sizes[0]));
  }

  [[nodiscard]] bool has(const char* name) const {
    return H5Lexists(root(), name, H5P_DEFAULT) > 0;
  }

  void check(herr_t status) const {
    if (status < 0) throw ResultRejected(damaged_);
  }

 private:
  [[nodiscard]] Handle owned(hid_t id, Handle::Closer closer) const {
    check(id < 0 ? -1 : 0);
    return {id, closer, damaged_};
  }

  std::string damaged_;
  QuietErrors quiet_;
  Handle file_;
};

WallLoad read_from(const Reader& reader, hid_t group) {
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
    reader.check(fits ? 0 : -1);
    load.values[m] = Eigen::Map<const Eigen::MatrixXd>(
        values.data(), load.bins(), static_cast<Eigen::Index>(sizes[0] * sizes[1]));
  }
  const auto rejected = reader.read_values(group, "rejected", 1).values;
  reader.check(rejected.size() == measure_count ? 0 : -1);
  std::copy(rejected.begin(), rejected.end(), load.rejected.begin());
  return load;
}

ImpactSpectrum spectrum_from(const Reader& reader, const Handle& group) {
  ImpactSpectrum spectrum{reader.read_matrix(group.id(), "normal_events"),
                          reader.read_matrix(group.id(), "normal_energy"),
                          reader.read_matrix(group.id(), "shear_events"),
                          reader.read_matrix(group.id(), "shear_energy"),
                          reader.read_matrix(group.id(), "unfinished").col(0)};
  reader.check(spectrum.normal_events.rows() == energy_classes ? 0 : -1);
  return spectrum;
}

ChargeMotion motion_from(const Reader& reader, const Handle& group, std::size_t blocks) {
  ChargeMotion motion = no_charge_motion(blocks);
  const auto take = [&](const std::string& name, auto into) {
    const Eigen::MatrixXd found = reader.read_matrix(group.id(), name);
    reader.check(found.rows() == into.rows() && found.cols() == into.cols() ? 0 : -1);
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

PairRecord pairs_from(const Reader& reader, const Handle& group) {
  return {reader.read_number(group.id(), "duration"), spectrum_from(reader, group),
          reader.read_number(group.id(), "normal_dissipation"),
          reader.read_number(group.id(), "shear_dissipation"),
          reader.read_number(group.id(), "rolling_dissipation")};
}

}  // namespace

LinerRecord read_record(const std::filesystem::path& path) {
  const Reader reader(path, one_load);
  LinerRecord record{};
  record.load = read_from(reader, reader.root());
  const Handle angles = reader.group("charge_angles");
  record.angles = {reader.read_matrix(angles.id(), "contacts"),
                   reader.read_matrix(angles.id(), "normal_force")};
  reader.check(record.angles.contacts.rows() == degrees_around ? 0 : -1);
  record.spectrum = spectrum_from(reader, reader.group("liner_collisions"));
  if (reader.has("triangles")) record.triangles = reader.read_matrix(reader.root(), "triangles");
  if (reader.has("particle_collisions"))
    record.pairs = pairs_from(reader, reader.group("particle_collisions"));
  if (reader.has("charge_motion"))
    record.motion = motion_from(reader, reader.group("charge_motion"), record.load.block_count);
  if (reader.has("goal")) {
    const Handle goal = reader.group("goal");
    record.goal = {reader.read_number(goal.id(), "target_relative_error"),
                   reader.read_number(goal.id(), "peak_relative_error")};
  }
  return record;
}

WallLoad read_load(const std::filesystem::path& path) {
  const Reader reader(path, one_load);
  return read_from(reader, reader.root());
}

std::vector<StoredLoad> read_loads(const std::filesystem::path& path) {
  const Reader reader(path, many_loads);
  std::vector<StoredLoad> loads;
  for (const std::string& name : reader.names()) {
    const std::string number = name.substr(std::min(name.size(), name.find('_') + 1));
    loads.push_back({std::atoi(number.c_str()), read_from(reader, reader.group(name).id())});
  }
  return loads;
}

}  // namespace millwear::wear
