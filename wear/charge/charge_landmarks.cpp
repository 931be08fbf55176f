#include "wear/charge/charge_landmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mill/liner/mill_frame.h"
#include "wear/numerics/closed_curve.h"

namespace millwear::wear {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index degrees = 360;
constexpr Index smoothed_over = 3;  // degrees to either side
constexpr double bulk_percentile = 0.9;
constexpr double share_of_bulk = 0.5;
constexpr double reached_share = 0.01;

using Grid = Eigen::Map<const Eigen::ArrayXXd>;

/// A sum over the section, columns (along x) by rows (along z).
Grid grid_of(const ChargeFields& fields, FieldSum sum) {
  return {fields.sums.col(static_cast<Index>(sum)).data(), fields.grid.cells, fields.grid.cells};
}

double coordinate(const SectionGrid& grid, double line) {
  return (line + 0.5) * grid.cell_size() - grid.half_width;
}

/// The occupied share on a circle, by degree from six o'clock along the rotation.
VectorXd occupied_around(const ChargeFields& fields, double radius) {
  VectorXd raw(degrees);
  for (Index i = 0; i < degrees; ++i) {
    const double angle = static_cast<double>(i) * pi / 180.0;
    raw[i] = interpolated(fields, FieldSum::solid,
                          {-radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return running_mean(raw, smoothed_over);
}

/// Where the occupied share falls below a level, on the way from a degree; NaN where nowhere.
double end_of_bulk(const VectorXd& occupied, double level, Index from, int direction) {
  const auto steps = steps_until_below(occupied, level, from, direction);
  if (!steps) return nan;
  return from_three_oclock((static_cast<double>(from) + direction * *steps) * pi / 180.0);
}

Vector2d head_of(const ChargeFields& fields) {
  const Eigen::ArrayXXd occupied = grid_of(fields, FieldSum::solid) / fields.instants;
  for (Index row = occupied.cols(); row-- > 0;) {
    Index column = 0;
    if (occupied.col(row).maxCoeff(&column) > reached_share)
      return {coordinate(fields.grid, static_cast<double>(column)),
              coordinate(fields.grid, static_cast<double>(row))};
  }
  return {nan, nan};
}

/// Where a parabola through three neighbouring values is greatest, from the middle one, -0.5 to
/// 0.5.
double greatest_between(double before, double middle, double after) {
  const double bend = before - 2.0 * middle + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

Vector2d centre_of_circulation(const ChargeFields& fields) {
  Eigen::ArrayXXd stream = grid_of(fields, FieldSum::momentum_z);
  for (Index column = 1; column < stream.rows(); ++column)
    stream.row(column) += stream.row(column - 1);
  Index column = 0;
  Index row = 0;
  if (!(stream.maxCoeff(&column, &row) > 0.0) || column == 0 || row == 0 ||
      column == stream.rows() - 1 || row == stream.cols() - 1)
    return {nan, nan};
  const auto at = [&](Index dx, Index dz) { return stream(column + dx, row + dz); };
  // The stream function of a cell's column holds up to its right edge.
  return {coordinate(fields.grid, static_cast<double>(column) + 0.5 +
                                      greatest_between(at(-1, 0), at(0, 0), at(1, 0))),
          coordinate(fields.grid,
                     static_cast<double>(row) + greatest_between(at(0, -1), at(0, 0), at(0, 1)))};
}

}  // namespace

ChargeLandmarks landmarks_of(const ChargeFields& fields, double radius) {
  ChargeLandmarks found{nan, nan, head_of(fields), centre_of_circulation(fields)};
  const VectorXd occupied = occupied_around(fields, radius);
  Index fullest = 0;
  if (!(occupied.maxCoeff(&fullest) > 0.0)) return found;
  const double level = share_of_bulk * percentile(occupied, bulk_percentile);
  found.shoulder = end_of_bulk(occupied, level, fullest, 1);
  found.bulk_toe = end_of_bulk(occupied, level, fullest, -1);
  return found;
}

}  // namespace millwear::wear
