#include "orchestrator/comparison/differing_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "orchestrator/campaign/case_difference.h"

namespace millwear::orchestrator {
namespace {

constexpr std::size_t longest_value = 40;

/// A number to ten digits, an outline by its points, other values up to a length.
std::string spoken_value(const std::string& value) {
  double number = 0.0;
  const auto* const end = value.data() + value.size();
  if (std::from_chars(value.data(), end, number).ptr == end) return fmt::format("{:.10g}", number);
  if (value.size() <= longest_value) return value;
  const auto points = std::ranges::count(value, '[') - 1;
  return points > 0 ? fmt::format("{} points", points) : value.substr(0, longest_value) + "...";
}

}  // namespace

std::vector<DifferingKey> differing_keys(const std::vector<Case>& cases) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> values;
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (const auto& [key, value] : locked_values(cases[i])) {
      auto [found, is_new] = values.try_emplace(key, cases.size(), "none");
      if (is_new) order.push_back(key);
      found->second[i] = value;
    }
  std::vector<DifferingKey> differing;
  for (const auto& key : order) {
    auto& of_cases = values.at(key);
    if (std::ranges::all_of(of_cases, [&](const auto& value) { return value == of_cases[0]; }))
      continue;
    std::ranges::transform(of_cases, of_cases.begin(), spoken_value);
    differing.push_back({key, of_cases});
  }
  return differing;
}

}  // namespace millwear::orchestrator
