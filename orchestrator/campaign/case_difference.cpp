#include "orchestrator/campaign/case_difference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <sstream>
#include <utility>

#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"

namespace millwear::orchestrator {
namespace {

constexpr std::size_t most_named = 5;

/// A key by its table, the table's number among those of its name, and its own name.
struct LockedKey {
  std::string table;
  int number;
  std::string key;
  auto operator<=>(const LockedKey&) const = default;
};

/// The keys of a locked case as they are written there; an array of many lines is one value.
std::vector<std::pair<LockedKey, std::string>> locked_keys(const Case& mill) {
  std::vector<std::pair<LockedKey, std::string>> keys;
  std::map<std::string, int> tables;
  std::string table;
  std::istringstream text(locked_case_text(mill));
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '[') {
      table = line;
      ++tables[table];
    } else if (const auto equals = line.find(" = "); equals != std::string::npos) {
      keys.push_back({{table, tables[table], line.substr(0, equals)}, line.substr(equals + 3)});
    } else {
      keys.back().second += line;
    }
  }
  return keys;
}

std::string spoken_key(const LockedKey& key) {
  const bool repeats = key.table.starts_with("[[");
  return fmt::format("{}{}`{}`", key.table.empty() ? "" : key.table + " ",
                     repeats ? fmt::format("number {} ", key.number) : "", key.key);
}

std::string spoken_value(const std::string& value) {
  constexpr std::size_t longest = 40;
  return value.size() > longest ? "other numbers" : value;
}

}  // namespace

std::vector<LockedValue> locked_values(const Case& mill) {
  std::vector<LockedValue> values;
  for (const auto& [key, value] : locked_keys(mill)) values.push_back({spoken_key(key), value});
  return values;
}

std::vector<std::string> differences(const Case& here, const Case& there) {
  const auto keys_here = locked_keys(here);
  const auto keys_there = locked_keys(there);
  const std::map<LockedKey, std::string> values(keys_there.begin(), keys_there.end());
  const std::map<LockedKey, std::string> own(keys_here.begin(), keys_here.end());
  std::vector<std::string> texts;
  for (const auto& [key, value] : keys_here) {
    const auto found = values.find(key);
    if (found == values.end())
      texts.push_back(fmt::format("{} ({}, there none)", spoken_key(key), spoken_value(value)));
    else if (found->second != value)
      texts.push_back(fmt::format("{} ({}, there {})", spoken_key(key), spoken_value(value),
                                  spoken_value(found->second)));
  }
  for (const auto& [key, value] : keys_there)
    if (!own.contains(key))
      texts.push_back(fmt::format("{} (none, there {})", spoken_key(key), spoken_value(value)));
  return texts;
}

Case with_law_of(const Case& here, const Case& there, std::string_view folder) {
  Case result = there;
  result.wear.mechanisms = here.wear.mechanisms;
  result.campaign = here.campaign;
  result.campaign.reversal_times = there.campaign.reversal_times;
  result.campaign.operation = there.campaign.operation;
  auto texts = differences(here, result);
  if (texts.empty()) return result;
  const std::size_t more = texts.size() - std::min(texts.size(), most_named);
  texts.resize(std::min(texts.size(), most_named));
  throw InputError(fmt::format(
      "{}: the loads in {} are of another case; it differs in {}{}; only the laws of [wear] and "
      "[campaign] may differ, so start from a copy of case.lock.toml, or run this case",
      here.file.string(), folder, fmt::join(texts, ", "),
      more > 0 ? fmt::format(" and {} more", more) : ""));
}

}  // namespace millwear::orchestrator
