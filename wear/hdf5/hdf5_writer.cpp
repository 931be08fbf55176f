#include "wear/hdf5/hdf5_writer.h"

#include <hdf5.h>

#include <fstream>

namespace millwear::wear {
namespace {

constexpr unsigned deflate_level = 4;

Handle untimed(hid_t kind, const std::string& failure) {
  Handle options(H5Pcreate(kind), H5Pclose, failure);
  if (H5Pset_obj_track_times(options.id(), false) < 0) throw DiskError(failure);
  return options;
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, const FileFormat& format)
    : path_(path), failure_(unwritten_text(path)), file_(create()) {
  write_format(root(), format, failure_);
}

Handle Hdf5Writer::create() const {
  constexpr std::size_t growth = 1 << 20;
  const Handle options = untimed(H5P_FILE_CREATE, failure_);
  const Handle access = unlocked_access(failure_);
  check(H5Pset_fapl_core(access.id(), growth, false));
  return {H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, options.id(), access.id()), H5Fclose, failure_};
}

void Hdf5Writer::check(int status) const {
  if (status < 0) throw DiskError(failure_);
}

Handle Hdf5Writer::new_group(const std::string& name) const {
  const Handle options = untimed(H5P_GROUP_CREATE, failure_);
  return {H5Gcreate2(root(), name.c_str(), H5P_DEFAULT, options.id(), H5P_DEFAULT), H5Gclose,
          failure_};
}

Handle Hdf5Writer::new_set(std::int64_t group, std::string_view name, const Extents& sizes,
                           NumberType type) const {
  const auto rank = static_cast<int>(sizes.size());
  const Handle space(H5Screate_simple(rank, sizes.data(), nullptr), H5Sclose, failure_);
  const Handle options = untimed(H5P_DATASET_CREATE, failure_);
  check(H5Pset_chunk(options.id(), rank, sizes.data()));
  check(H5Pset_shuffle(options.id()));
  check(H5Pset_deflate(options.id(), deflate_level));
  return {H5Dcreate2(group, std::string(name).c_str(), in_file(type), space.id(), H5P_DEFAULT,
                     options.id(), H5P_DEFAULT),
          H5Dclose, failure_};
}

void Hdf5Writer::write_numbers(std::int64_t group, std::string_view name, std::string_view unit,
                               const Extents& sizes, NumberType type, const void* values) const {
  Handle set = new_set(group, name, sizes, type);
  check(H5Dwrite(set.id(), in_memory(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  write_attribute(set.id(), "unit", unit, failure_);
  set.close(failure_);
}

void Hdf5Writer::write_number(std::int64_t group, std::string_view name, std::string_view unit,
                              double value) const {
  write_values(group, name, unit, {1}, &value);
}

void Hdf5Writer::write_matrix(std::int64_t group, std::string_view name, std::string_view unit,
                              const Eigen::MatrixXd& values) const {
  write_values(group, name, unit,
               {static_cast<unsigned long long>(values.cols()),
                static_cast<unsigned long long>(values.rows())},
               values.data());
}

void Hdf5Writer::publish() {
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

}  // namespace millwear::wear
