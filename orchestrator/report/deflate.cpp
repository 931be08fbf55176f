#include "orchestrator/report/deflate.h"

#include <zlib.h>

#include <new>

namespace millwear::orchestrator {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::vector<std::uint8_t> packed(size);
  if (::compress(packed.data(), &size, bytes.data(), bytes.size()) != Z_OK) throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace millwear::orchestrator
