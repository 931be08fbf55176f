#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "mill/failure.h"

namespace millwear::wear {

inline constexpr std::string_view one_load = "millwear wall load";
inline constexpr std::string_view many_loads = "millwear wall loads";

/// Owns one HDF5 identifier. `close` is where a failed write shows, so writers call it and look;
/// the destructor is for the way out of an error only.
class Handle {
 public:
  using Closer = int (*)(std::int64_t);
  Handle(std::int64_t id, Closer closer, const std::string& failure) : id_(id), closer_(closer) {
    if (id < 0) throw DiskError(failure);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) closer_(id_);
  }

  [[nodiscard]] std::int64_t id() const { return id_; }

  void close(const std::string& failure) {
    if (closer_(std::exchange(id_, -1)) < 0) throw DiskError(failure);
  }

 private:
  std::int64_t id_;
  Closer closer_;
};

/// HDF5 keeps its error stack off stderr while this lives.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors();
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  int (*function_)(std::int64_t, void*);
  void* data_;
};

}  // namespace millwear::wear
