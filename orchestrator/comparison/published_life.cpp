#include "orchestrator/comparison/published_life.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A number of the summary; NaN for null.
double number_in(const nlohmann::json& summary, const char* key) {
  const auto& value = summary.at(key);
  return value.is_number() ? value.get<double>() : nan;
}

}  // namespace

Life published_life(const std::filesystem::path& tables, const std::vector<HistoryRow>& history,
                    const Life& before) {
  const auto file = tables / "summary.json";
  if (!std::filesystem::exists(file)) {
    if (history.empty()) return before;
    return {false, history.back().operating_hours, nan, nan, history.back().tonnes, before.limit};
  }
  try {
    const auto summary = nlohmann::json::parse(read_file(file));
    return {summary.at("life_reached").get<bool>(), number_in(summary, "life_hours"),
            number_in(summary, "life_hours_low"),   number_in(summary, "life_hours_high"),
            number_in(summary, "life_tonnes"),      summary.at("limit").get<std::string>()};
  } catch (const nlohmann::json::exception& problem) {
    throw ResultRejected(
        fmt::format("{}: {}; `millwear report` writes it again", file.string(), problem.what()));
  }
}

}  // namespace millwear::orchestrator
