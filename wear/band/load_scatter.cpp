#include "wear/band/load_scatter.h"

#include <algorithm>
#include <cmath>

namespace millwear::wear {

double birge_ratio(std::span<const TimedLoad* const> loads) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 1; i + 1 < loads.size(); ++i) {
    const TimedLoad& middle = *loads[i];
    const ZonedLoad before = zoned(*loads[i - 1], middle.profile);
    const ZonedLoad here = zoned(middle, middle.profile);
    const ZonedLoad after = zoned(*loads[i + 1], middle.profile);
    const double share =
        (middle.time - loads[i - 1]->time) / (loads[i + 1]->time - loads[i - 1]->time);
    const Eigen::ArrayXd apart = here.rate - (1.0 - share) * before.rate - share * after.rate;
    const Eigen::ArrayXd variance = here.variance + std::pow(1.0 - share, 2) * before.variance +
                                    std::pow(share, 2) * after.variance;
    for (Eigen::Index zone = 0; zone < apart.size(); ++zone) {
      if (!(variance[zone] > 0.0)) continue;
      sum += apart[zone] * apart[zone] / variance[zone];
      ++count;
    }
  }
  return count > 0 ? std::max(1.0, std::sqrt(sum / count)) : 1.0;
}

}  // namespace millwear::wear
