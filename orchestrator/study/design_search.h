#pragma once
#include <cstdint>
#include <vector>

namespace millwear::orchestrator {

/// An axis of a search.
struct SearchInterval {
  double low;
  double high;
  bool is_whole;  ///< takes whole numbers only
};

/// What a search has found at a place.
struct SearchValue {
  std::vector<double> place;  ///< a number an axis
  double value;               ///< to be made large
  double error;               ///< its standard error
};

/// The places to try next, so many at once, from the values found so far: the global maximum of a
/// dear function. The same values, count and seed give the same places. Noise is taken into account
/// as the mean error over the range of the values. At least one axis (std::logic_error).
/// Method: dlib's `global_function_search`, an upper bound of the function by its slopes, in turn
/// with a trust region about the best place (King 2009, JMLR 10, 1755; Malherbe and Vayatis 2017,
/// ICML).
[[nodiscard]] std::vector<std::vector<double>> next_places(const std::vector<SearchInterval>& axes,
                                                           const std::vector<SearchValue>& found,
                                                           std::size_t count, std::uint64_t seed);

}  // namespace millwear::orchestrator
