#pragma once
#include <Eigen/Core>
#include <cereal/archives/binary.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <exception>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
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

/// The `serialize` of a struct that is kept as its bytes.
template <class Archive, class T>
void serialize_bytes(Archive& archive, T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  archive(cereal::binary_data(&value, sizeof value));
}

/// Publishes a value under its key. Throws DiskError.
template <class T>
void keep_value(const std::filesystem::path& file, std::string_view key, const T& value) {
  std::ostringstream bytes;
  cereal::BinaryOutputArchive{bytes}(value);
  keep(file, key, std::move(bytes).str());
}

/// The value that was kept under this key; nothing where there is none, or the bytes are not those
/// of such a value, as after a build that its version does not tell from this one.
template <class T>
[[nodiscard]] std::optional<T> kept_value(const std::filesystem::path& file, std::string_view key) {
  auto kept = kept_bytes(file, key);
  if (!kept) return std::nullopt;
  std::istringstream bytes(std::move(*kept));
  try {
    T value{};
    cereal::BinaryInputArchive{bytes}(value);
    if (bytes.peek() == std::istringstream::traits_type::eof()) return value;
  } catch (const std::exception&) {  // ends early, or a length that no memory holds
  }
  return std::nullopt;
}

}  // namespace millwear::orchestrator
