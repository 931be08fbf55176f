#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cereal/archives/binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdint>
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

namespace millwear::orchestrator {

/// Reads values from kept bytes. A length past their end throws before it asks for memory.
class KeptInput : public cereal::InputArchive<KeptInput, cereal::AllowEmptyClassElision> {
 public:
  explicit KeptInput(std::string_view bytes)
      : cereal::InputArchive<KeptInput, cereal::AllowEmptyClassElision>(this), bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return bytes_.empty(); }

  void expect(std::uint64_t size) const {
    if (size > bytes_.size()) throw cereal::Exception("the bytes end early");
  }

  void read(void* value, std::uint64_t size) {
    expect(size);
    std::copy_n(bytes_.data(), size, static_cast<char*>(value));
    bytes_.remove_prefix(size);
  }

 private:
  std::string_view bytes_;
};

template <class T>
requires std::is_arithmetic_v<T>
void load(KeptInput& archive, T& value) { archive.read(&value, sizeof value); }

template <class T>
void load(KeptInput& archive, cereal::BinaryData<T>& bytes) {
  archive.read(bytes.data, bytes.size);
}

template <class T>
void load(KeptInput& archive, cereal::SizeTag<T>& length) {
  archive(length.size);
  archive.expect(length.size);
}

template <class T>
void load(KeptInput& archive, cereal::NameValuePair<T>& pair) {
  archive(pair.value);
}

}  // namespace millwear::orchestrator

template <>
struct cereal::traits::detail::get_output_from_input<millwear::orchestrator::KeptInput> {
  using type = cereal::BinaryOutputArchive;
};

namespace Eigen {

template <class Archive, class Scalar, int Rows, int Cols>
void save(Archive& archive, const Matrix<Scalar, Rows, Cols>& matrix) {
  const auto size = static_cast<std::size_t>(matrix.size());
  archive(cereal::make_size_tag(size), matrix.rows(),
          cereal::binary_data(matrix.data(), size * sizeof(Scalar)));
}

template <class Archive, class Scalar, int Rows, int Cols>
void load(Archive& archive, Matrix<Scalar, Rows, Cols>& matrix) {
  cereal::size_type size = 0;
  Index rows = 0;
  archive(cereal::make_size_tag(size), rows);
  const auto count = static_cast<Index>(size);
  if (rows < 0 || (rows == 0 ? count != 0 : count % rows != 0))
    throw cereal::Exception("no matrix has so many rows");
  matrix.resize(rows, rows == 0 ? 0 : count / rows);
  archive(cereal::binary_data(matrix.data(), size * sizeof(Scalar)));
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
  const auto bytes = kept_bytes(file, key);
  if (!bytes) return std::nullopt;
  try {
    T value{};
    KeptInput input(*bytes);
    input(value);
    if (input.at_end()) return value;
  } catch (const cereal::Exception&) {  // the bytes are of another kind
  }
  return std::nullopt;
}

}  // namespace millwear::orchestrator
