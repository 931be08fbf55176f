#pragma once
#include <span>

namespace millwear::wear {

/// What campaigns that differ in the seed alone say of one value. The three are NaN where one of
/// the values is.
struct Repeats {
  double mean;
  double scatter;          ///< standard deviation between the campaigns; NaN of one
  double predicted_error;  ///< root mean square of the standard errors that they give
};

/// `values` with their standard `errors`, one a campaign and at least one.
[[nodiscard]] Repeats repeats_of(std::span<const double> values, std::span<const double> errors);

}  // namespace millwear::wear
