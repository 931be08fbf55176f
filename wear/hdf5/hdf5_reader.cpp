#include "wear/hdf5/hdf5_reader.h"

#include <hdf5.h>

#include <array>

namespace millwear::wear {
Hdf5Reader::Hdf5Reader(const std::filesystem::path& path, const FileFormat& format)
    : damaged_(damaged_text(path)), file_(open_to_read(path, format)) {}

void Hdf5Reader::require(bool is_right) const {
  if (!is_right) throw ResultRejected(damaged_);
}

Handle Hdf5Reader::group(const std::string& name) const {
  const hid_t id = H5Gopen2(root(), name.c_str(), H5P_DEFAULT);
  require(id >= 0);
  return {id, H5Gclose, damaged_};
}

std::vector<std::string> Hdf5Reader::names() const {
  H5G_info_t info{};
  check(H5Gget_info(root(), &info));
  std::vector<std::string> found;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 64> name{};
    require(H5Lget_name_by_idx(root(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(),
                               H5P_DEFAULT) >= 0);
    found.emplace_back(name.data());
  }
  return found;
}

bool Hdf5Reader::has(const char* name) const { return H5Lexists(root(), name, H5P_DEFAULT) > 0; }

Handle Hdf5Reader::dataset(std::int64_t group, std::string_view name) const {
  const hid_t id = H5Dopen2(group, std::string(name).c_str(), H5P_DEFAULT);
  require(id >= 0);
  return {id, H5Dclose, damaged_};
}

Extents Hdf5Reader::extents(const Handle& set, int rank) const {
  const hid_t id = H5Dget_space(set.id());
  require(id >= 0);
  const Handle space{id, H5Sclose, damaged_};
  require(H5Sget_simple_extent_ndims(space.id()) == rank);
  Extents sizes(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space.id(), sizes.data(), nullptr));
  return sizes;
}

void Hdf5Reader::read_numbers(const Handle& set, NumberType type, void* values) const {
  check(H5Dread(set.id(), in_memory(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
}

double Hdf5Reader::read_number(std::int64_t group, std::string_view name) const {
  const auto found = read_values(group, name, 1);
  require(found.values.size() == 1);
  return found.values.front();
}

Eigen::MatrixXd Hdf5Reader::read_matrix(std::int64_t group, std::string_view name) const {
  const auto [sizes, values] = read_values(group, name, 2);
  return Eigen::Map<const Eigen::MatrixXd>(values.data(), static_cast<Eigen::Index>(sizes[1]),
                                           static_cast<Eigen::Index>(sizes[0]));
}

}  // namespace millwear::wear
