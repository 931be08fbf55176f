#include "wear/band/repeats.h"

#include <cmath>
#include <limits>

#include "mill/base/contract.h"

namespace millwear::wear {

Repeats repeats_of(std::span<const double> values, std::span<const double> errors) {
  expect(!values.empty() && values.size() == errors.size(), "repeats are values with their errors");
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double deviations = 0.0;
  for (const double value : values) deviations += (value - mean) * (value - mean);
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  return {mean,
          values.size() > 1 ? std::sqrt(deviations / (count - 1.0))
                            : std::numeric_limits<double>::quiet_NaN(),
          std::sqrt(squares / count)};
}

}  // namespace millwear::wear
