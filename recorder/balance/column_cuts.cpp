#include "recorder/balance/column_cuts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace millwear::recorder {
namespace {

/// The place up to which `share` of all particles lie.
double place_of_share(std::span<const double> counts, double share) {
  const double wanted = share * std::reduce(counts.begin(), counts.end());
  double before = 0.0;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    if (counts[bin] > 0.0 && before + counts[bin] >= wanted)
      return (static_cast<double>(bin) + (wanted - before) / counts[bin]) /
             static_cast<double>(counts.size());
    before += counts[bin];
  }
  return share;
}

}  // namespace

std::vector<double> column_cuts(std::span<const double> counts, int columns, double least_width) {
  const double width = std::min(least_width, 1.0 / columns);
  std::vector<double> cuts = {0.0};
  for (int cut = 1; cut < columns; ++cut) {
    const double wanted = place_of_share(counts, static_cast<double>(cut) / columns);
    cuts.push_back(std::max(cuts.back() + width, std::min(wanted, 1.0 - (columns - cut) * width)));
  }
  cuts.push_back(1.0);
  return cuts;
}

}  // namespace millwear::recorder
