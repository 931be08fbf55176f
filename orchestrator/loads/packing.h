#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "mill/base/failure.h"

/// Values as bytes and back, bit by bit: for files that this program keeps for itself.
namespace millwear::orchestrator {

/// The members of a struct that is packed: `static constexpr auto all = std::tuple(&T::a, ...)`.
/// Numbers and structs that can be copied byte by byte need none.
template <class T>
struct Fields;

namespace packing {

template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
concept Matrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    if constexpr (Plain<T>) {
      put_bytes(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      put<std::uint64_t>(value.size());
      put_bytes(value.data(), value.size());
    } else if constexpr (IsVector<T>::value) {
      put<std::uint64_t>(value.size());
      if constexpr (Plain<typename T::value_type>)
        put_bytes(value.data(), value.size() * sizeof(typename T::value_type));
      else
        for (const auto& item : value) put(item);
    } else if constexpr (IsOptional<T>::value) {
      put(value.has_value());
      if (value) put(*value);
    } else if constexpr (Matrix<T>) {
      put<std::int64_t>(value.rows());
      put<std::int64_t>(value.cols());
      put_bytes(value.data(), static_cast<std::size_t>(value.size()) * sizeof(typename T::Scalar));
    } else {
      std::apply([&](auto... member) { (put(value.*member), ...); }, Fields<T>::all);
    }
  }

  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  void put_bytes(const void* from, std::size_t size) {
    bytes_.append(static_cast<const char*>(from), size);
  }

  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  void get(T& value) {
    if constexpr (Plain<T>) {
      take(&value, 1, sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      value.resize(count(1));
      take(value.data(), value.size(), 1);
    } else if constexpr (IsVector<T>::value) {
      using Item = typename T::value_type;
      if constexpr (Plain<Item>) {
        value.resize(count(sizeof(Item)));
        take(value.data(), value.size(), sizeof(Item));
      } else {
        value.resize(count(1));
        for (auto& item : value) get(item);
      }
    } else if constexpr (IsOptional<T>::value) {
      bool there = false;
      get(there);
      if (there) get(value.emplace());
    } else if constexpr (Matrix<T>) {
      std::int64_t rows = 0;
      std::int64_t cols = 0;
      get(rows);
      get(cols);
      const auto most = static_cast<std::int64_t>(left_.size() / sizeof(typename T::Scalar));
      if (rows < 0 || cols < 0 || (cols > 0 && rows > most / cols)) too_short();
      value.resize(rows, cols);
      take(value.data(), static_cast<std::size_t>(value.size()), sizeof(typename T::Scalar));
    } else {
      std::apply([&](auto... member) { (get(value.*member), ...); }, Fields<T>::all);
    }
  }

  [[nodiscard]] bool is_at_end() const { return left_.empty(); }

 private:
  [[noreturn]] static void too_short() { throw ResultRejected("packed values end early"); }

  /// How many items of at least `size` bytes follow.
  std::size_t count(std::size_t size) {
    std::uint64_t items = 0;
    get(items);
    if (items > left_.size() / size) too_short();
    return items;
  }

  void take(void* into, std::size_t items, std::size_t size) {
    if (items * size > left_.size()) too_short();
    if (items > 0) std::memcpy(into, left_.data(), items * size);
    left_.remove_prefix(items * size);
  }

  std::string_view left_;
};

}  // namespace packing

template <class T>
[[nodiscard]] std::string packed_bytes(const T& value) {
  packing::Writer writer;
  writer.put(value);
  return std::move(writer).bytes();
}

/// The inverse. Throws ResultRejected where the bytes are not as many as such a value has.
template <class T>
[[nodiscard]] T unpacked(std::string_view bytes) {
  packing::Reader reader(bytes);
  T value{};
  reader.get(value);
  if (!reader.is_at_end()) throw ResultRejected("packed values go on after their end");
  return value;
}

}  // namespace millwear::orchestrator
