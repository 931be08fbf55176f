#pragma once
#include <span>
#include <vector>

namespace millwear::recorder {

/// Where `columns` columns are cut so that each holds equally many particles: `columns` + 1 places
/// along a width of 1, from 0 to 1, of which `counts` are the particles in even bins. Particles lie
/// evenly in a bin. Columns are at least `least_width` wide, as far as there is room; without
/// particles they are even.
[[nodiscard]] std::vector<double> column_cuts(std::span<const double> counts, int columns,
                                              double least_width);

}  // namespace millwear::recorder
