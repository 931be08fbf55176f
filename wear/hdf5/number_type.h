#pragma once
#include <cstdint>
#include <vector>

namespace millwear::wear {

/// Numbers of a dataset, little-endian in the file.
enum class NumberType { real64, real32, natural16, natural8 };

constexpr NumberType number_type(const double*) { return NumberType::real64; }
constexpr NumberType number_type(const float*) { return NumberType::real32; }
constexpr NumberType number_type(const std::uint16_t*) { return NumberType::natural16; }
constexpr NumberType number_type(const std::uint8_t*) { return NumberType::natural8; }

/// Sizes of an array, the last running fastest.
using Extents = std::vector<unsigned long long>;

/// HDF5's identifiers of a type.
[[nodiscard]] std::int64_t in_memory(NumberType type);
[[nodiscard]] std::int64_t in_file(NumberType type);

}  // namespace millwear::wear
