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

/// Reads datasets of a file that `Hdf5Writer` wrote. All throw ResultRejected where the file is
/// damaged.
class Hdf5Reader {
 public:
  /// Throws as `open_to_read`.
  Hdf5Reader(const std::filesystem::path& path, const FileFormat& format);

  template <class T>
  struct Values {
    Extents sizes;
    std::vector<T> values;
  };

  [[nodiscard]] std::int64_t root() const { return file_.id(); }
  [[nodiscard]] Handle group(const std::string& name) const;
  /// Of what lies in the root, in the order of the alphabet.
  [[nodiscard]] std::vector<std::string> names() const;
  [[nodiscard]] bool has(const char* name) const;

  /// An array of so many dimensions.
  template <class T = double>
  [[nodiscard]] Values<T> read_values(std::int64_t group, std::string_view name, int rank) const {
    const Handle set = dataset(group, name);
    Values<T> found{extents(set, rank), {}};
    std::size_t count = 1;
    for (const auto size : found.sizes) count *= size;
    found.values.resize(count);
    read_numbers(set, number_type(found.values.data()), found.values.data());
    return found;
  }
  [[nodiscard]] double read_number(std::int64_t group, std::string_view name) const;
  /// As `Hdf5Writer::write_matrix` wrote it.
  [[nodiscard]] Eigen::MatrixXd read_matrix(std::int64_t group, std::string_view name) const;

  /// Throws ResultRejected unless what was read is as it has to be.
  void require(bool is_right) const;

 private:
  [[nodiscard]] Handle dataset(std::int64_t group, std::string_view name) const;
  [[nodiscard]] Extents extents(const Handle& set, int rank) const;
  void read_numbers(const Handle& set, NumberType type, void* values) const;
  void check(int status) const { require(status >= 0); }

  std::string damaged_;
  QuietErrors quiet_;
  Handle file_;
};

}  // namespace millwear::wear
