#pragma once
#include <Eigen/Core>
#include <cereal/archives/binary.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "orchestrator/loads/kept_file.h"

/// Values in a cycle's kept files. A struct that is kept has a `serialize(archive, value)` in its
/// own namespace, which names its members.

namespace Eigen {

template <class Archive, class Scalar, int Rows, int Cols>
void save(Archive& archive, const Matrix<Scalar, Rows, Cols>& matrix) {
  archive(
      matrix.rows(), matrix.cols(),
      cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

template <class Archive, class Scalar, int Rows, int Cols>
void load(Archive& archive, Matrix<Scalar, Rows, Cols>& matrix) {
  Index rows = 0;
  Index cols = 0;
  archive(rows, cols);
  matrix.resize(rows, cols);
  archive(
      cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

}  // namespace Eigen

namespace millwear::orchestrator {

/// Publishes a value under its key. Throws DiskError.
template <class T>
void keep_value(const std::filesystem::path& file, std::string_view key, const T& value) {
  std::ostringstream bytes;
  cereal::BinaryOutputArchive{bytes}(value);
  keep(file, key, std::move(bytes).str());
}

/// The value that was kept under this key, or nothing. The key holds the program's version and the
/// file a hash of its bytes, so that they are those of such a value.
template <class T>
[[nodiscard]] std::optional<T> kept_value(const std::filesystem::path& file, std::string_view key) {
  auto kept = kept_bytes(file, key);
  if (!kept) return std::nullopt;
  std::istringstream bytes(std::move(*kept));
  T value{};
  cereal::BinaryInputArchive{bytes}(value);
  return value;
}

}  // namespace millwear::orchestrator
