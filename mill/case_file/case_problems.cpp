#include "mill/case_file/case_problems.h"

#include <fmt/format.h>

#include <algorithm>

namespace millwear {

void CaseProblems::throw_if_any() const {
  if (problems_.empty()) {
    return;
  }
  auto sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (const auto& [line, problem] : sorted) {
    text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file_.string(), line, problem);
  }
  throw InputError(text);
}

}  // namespace millwear
