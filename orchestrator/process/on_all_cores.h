#pragma once
#include <cstddef>
#include <functional>

namespace millwear::orchestrator {

/// Calls work(0) ... work(count - 1), side by side on the cores there are. Throws what a call
/// threw, once all have ended. HDF5 serves one thread only: `work` must not use it.
void for_each_on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace millwear::orchestrator
