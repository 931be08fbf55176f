#include "orchestrator/study/search_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/csv.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "orchestrator/study/study_values.h"

namespace millwear::orchestrator {
namespace {

/// How far a point is off its limits, as shares of them; 0 where it keeps all.
double excess_of(const StudyResults& results, const PointResult& point) {
  double excess = 0.0;
  for (const Limit& limit : results.plan.study.limits) {
    const double value = figure_of(point, limit.result).mean;
    if (std::isnan(value)) return std::numeric_limits<double>::infinity();
    const double off =
        limit.kind == Limit::Kind::at_least ? limit.value - value : value - limit.value;
    excess += std::max(0.0, off) / std::max(std::abs(limit.value), 1e-300);
  }
  return excess;
}

std::string columns_of(const Study& search) {
  std::string names;
  for (const StudyAxis& axis : search.axes) names += (names.empty() ? "" : ",") + axis.key;
  return names;
}

constexpr std::string_view format_name = "millwear search 1";

}  // namespace

Study with_places(const Study& search, const std::vector<std::vector<double>>& places) {
  Study study = search;
  study.combine = Combine::table;
  const auto intervals = intervals_of(search);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    StudyAxis& axis = study.axes[i];
    for (const auto& place : places) {
      CaseValue value{axis.line, place[i]};
      if (intervals[i].is_whole) value.data = std::int64_t{std::llround(place[i])};
      axis.labels.push_back(label_of(value));
      axis.values.push_back(std::move(value));
    }
  }
  return study;
}

std::vector<SearchInterval> intervals_of(const Study& search) {
  std::vector<SearchInterval> intervals;
  for (const StudyAxis& axis : search.axes)
    intervals.push_back({axis.low, axis.high, is_whole_axis(axis.key)});
  return intervals;
}

std::vector<SearchValue> values_of(const StudyResults& results,
                                   const std::vector<std::vector<double>>& places) {
  const double sign =
      results.plan.study.objective->sense == Objective::Sense::maximise ? 1.0 : -1.0;
  std::vector<SearchValue> found;
  std::vector<double> excess;
  for (std::size_t i = 0; i < results.points.size(); ++i) {
    const PointResult& point = results.points[i];
    if (!std::isfinite(point.objective.mean)) continue;
    found.push_back({places[i], sign * point.objective.mean, deviation_of(point, point.objective)});
    excess.push_back(excess_of(results, point));
  }
  if (found.empty()) return found;
  const auto [least, most] = std::ranges::minmax_element(found, {}, &SearchValue::value);
  const double worst = least->value;
  const double range = std::max(most->value - worst, 1e-3 * std::abs(most->value));
  for (std::size_t i = 0; i < found.size(); ++i)
    if (excess[i] > 0.0) found[i].value = worst - range * std::min(1.0, excess[i]);
  return found;
}

std::vector<std::vector<double>> read_places(const std::filesystem::path& file,
                                             const Study& search) {
  std::vector<std::vector<double>> places;
  if (!std::filesystem::exists(file)) return places;
  const std::string names = columns_of(search);
  for (const CsvLine& line : read_csv(file, {format_name, names})) {
    CsvFields fields(file, line);
    auto& place = places.emplace_back();
    for (std::size_t i = 0; i < search.axes.size(); ++i) place.push_back(fields.number());
  }
  return places;
}

void write_places(const std::filesystem::path& file, const Study& search,
                  const std::vector<std::vector<double>>& places) {
  const std::string names = columns_of(search);
  std::string text = csv_head({format_name, names});
  for (const auto& place : places) {
    std::string row;
    for (const double number : place) row += (row.empty() ? "" : ",") + csv_number(number);
    text += row + "\n";
  }
  publish(file, text);
}

StudyPlan plan_so_far(const StudyFolder& folder, const Study& study) {
  if (study.combine != Combine::search) return plan_of(study);
  return plan_of(with_places(study, read_places(folder.search(), study)));
}

}  // namespace millwear::orchestrator
