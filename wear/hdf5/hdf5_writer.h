#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "wear/hdf5/hdf5_file.h"
#include "wear/hdf5/number_type.h"

namespace millwear::wear {

/// An HDF5 file that is built in memory and written in one go, for HDF5 itself can hide a full
/// disk. The same bytes for the same values: without times, each dataset in one chunk, shuffled and
/// deflated. All throw DiskError where HDF5 or the disk fails.
class Hdf5Writer {
 public:
  /// Writes straight to `path`: publishing it (beside, fsync, rename) is the caller's.
  Hdf5Writer(const std::filesystem::path& path, const FileFormat& format);

  [[nodiscard]] std::int64_t root() const { return file_.id(); }
  [[nodiscard]] Handle new_group(const std::string& name) const;

  /// An array of these sizes.
  template <class T>
  void write_values(std::int64_t group, std::string_view name, std::string_view unit,
                    const Extents& sizes, const T* values) const {
    write_numbers(group, name, unit, sizes, number_type(values), values);
  }
  void write_number(std::int64_t group, std::string_view name, std::string_view unit,
                    double value) const;
  /// As rows of the file's array: a column of the matrix each.
  void write_matrix(std::int64_t group, std::string_view name, std::string_view unit,
                    const Eigen::MatrixXd& values) const;

  /// An empty dataset, for values that are packed already.
  [[nodiscard]] Handle new_set(std::int64_t group, std::string_view name, const Extents& sizes,
                               NumberType type) const;

  /// Throws DiskError where an HDF5 call gave a negative status.
  void check(int status) const;
  [[nodiscard]] const std::string& failure() const { return failure_; }

  /// Ends the file in memory and puts its bytes on the disk.
  void publish();

 private:
  void write_numbers(std::int64_t group, std::string_view name, std::string_view unit,
                     const Extents& sizes, NumberType type, const void* values) const;
  [[nodiscard]] Handle create() const;

  std::filesystem::path path_;
  std::string failure_;
  QuietErrors quiet_;
  Handle file_;
};

}  // namespace millwear::wear
