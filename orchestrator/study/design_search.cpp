#include "orchestrator/study/design_search.h"

#include <dlib/global_optimization/global_function_search.h>

#include <algorithm>
#include <cmath>

#include "mill/base/contract.h"

namespace millwear::orchestrator {
namespace {

using Column = dlib::matrix<double, 0, 1>;

constexpr double least_noise = 1e-3;
constexpr double most_noise = 1.0;

Column column_of(const std::vector<double>& values) {
  Column column(static_cast<long>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) column(static_cast<long>(i)) = values[i];
  return column;
}

dlib::function_spec spec_of(const std::vector<SearchInterval>& axes) {
  std::vector<double> low;
  std::vector<double> high;
  std::vector<bool> is_whole;
  for (const SearchInterval& axis : axes) {
    low.push_back(axis.is_whole ? std::ceil(axis.low) : axis.low);
    high.push_back(axis.is_whole ? std::floor(axis.high) : axis.high);
    is_whole.push_back(axis.is_whole);
  }
  return {column_of(low), column_of(high), is_whole};
}

/// The mean error over the range of the values.
double relative_noise(const std::vector<SearchValue>& found) {
  if (found.size() < 2) return least_noise;
  const auto [least, most] = std::ranges::minmax_element(found, {}, &SearchValue::value);
  double errors = 0.0;
  for (const SearchValue& one : found) errors += std::isfinite(one.error) ? one.error : 0.0;
  const double range = most->value - least->value;
  if (!(range > 0.0)) return least_noise;
  return std::clamp(errors / static_cast<double>(found.size()) / range, least_noise, most_noise);
}

}  // namespace

std::vector<std::vector<double>> next_places(const std::vector<SearchInterval>& axes,
                                             const std::vector<SearchValue>& found,
                                             std::size_t count, std::uint64_t seed) {
  expect(!axes.empty(), "a search has an axis or more");
  std::vector<dlib::function_evaluation> known;
  for (const SearchValue& one : found) known.emplace_back(column_of(one.place), one.value);
  dlib::global_function_search search({spec_of(axes)}, {known}, relative_noise(found));
  search.set_seed(static_cast<time_t>(seed + found.size()));
  std::vector<dlib::function_evaluation_request> requests;
  std::vector<std::vector<double>> places;
  for (std::size_t i = 0; i < count; ++i) {
    requests.push_back(search.get_next_x());
    const Column& x = requests.back().x();
    places.emplace_back(x.begin(), x.end());
  }
  return places;
}

}  // namespace millwear::orchestrator
