#include "orchestrator/process/on_all_cores.h"

#include <atomic>
#include <future>
#include <vector>

#include "orchestrator/process/usable_cores.h"

namespace millwear::orchestrator {

void for_each_on_all_cores(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto some = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> workers;
  for (int i = 1; i < usable_cores(); ++i) workers.push_back(std::async(std::launch::async, some));
  some();
  for (auto& worker : workers) worker.get();
}

}  // namespace millwear::orchestrator
