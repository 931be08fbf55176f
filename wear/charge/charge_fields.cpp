#include "wear/charge/charge_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace millwear::wear {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

auto sum(const ChargeFields& fields, FieldSum which) {
  return fields.sums.col(static_cast<Index>(which));
}

/// The column or row of a coordinate, inside the grid.
int line_of(const SectionGrid& grid, double coordinate) {
  const double line = std::floor((coordinate + grid.half_width) / grid.cell_size());
  return static_cast<int>(std::clamp(line, 0.0, grid.cells - 1.0));
}

Index cell_of(const SectionGrid& grid, const Eigen::Vector3d& place) {
  return line_of(grid, place.x()) + Index{grid.cells} * line_of(grid, place.z());
}

double middle(const SectionGrid& grid, int line) {
  return (line + 0.5) * grid.cell_size() - grid.half_width;
}

}  // namespace

ChargeFields no_charge_fields(const SectionGrid& grid, double slice_length,
                              std::size_t class_count) {
  const Index cells = grid.count();
  return {.grid = grid,
          .slice_length = slice_length,
          .instants = 0.0,
          .sums = Eigen::MatrixXd::Zero(cells, field_sum_count),
          .class_mass = Eigen::MatrixXd::Zero(cells, static_cast<Index>(class_count)),
          .pair_duration = 0.0,
          .normal_dissipation = VectorXd::Zero(cells),
          .shear_dissipation = VectorXd::Zero(cells)};
}

ChargeFieldSums::ChargeFieldSums(const SectionGrid& grid, double slice_length,
                                 std::size_t class_count)
    : fields_(no_charge_fields(grid, slice_length, class_count)) {}

void ChargeFieldSums::add(const ChargeParticle& particle) {
  const SectionGrid& grid = fields_.grid;
  const auto& [place, velocity, radius, mass, kind] = particle;
  chords_.clear();
  double total = 0.0;
  const int last_row = line_of(grid, place.z() + radius);
  const int last_column = line_of(grid, place.x() + radius);
  for (int row = line_of(grid, place.z() - radius); row <= last_row; ++row)
    for (int column = line_of(grid, place.x() - radius); column <= last_column; ++column) {
      const double x = middle(grid, column) - place.x();
      const double z = middle(grid, row) - place.z();
      const double half_chord_squared = radius * radius - x * x - z * z;
      if (half_chord_squared <= 0.0) continue;
      const double chord = 2.0 * std::sqrt(half_chord_squared);
      const Index cell = column + Index{grid.cells} * row;
      chords_.emplace_back(cell, chord);
      total += chord;
    }
  // A particle between the middles of the cells counts to the one where its centre is.
  if (chords_.empty()) {
    chords_.emplace_back(cell_of(grid, place), 1.0);
    total = 1.0;
  }
  const double volume = 4.0 / 3.0 * M_PI * radius * radius * radius;
  const double cell_volume = grid.cell_size() * grid.cell_size() * fields_.slice_length;
  const Eigen::Matrix<double, field_sum_count, 1> values{
      volume / cell_volume, mass,
      mass * velocity.x(),  mass * velocity.y(),
      mass * velocity.z(),  mass * velocity.squaredNorm()};
  for (const auto& [cell, chord] : chords_) {
    const double share = chord / total;
    fields_.sums.row(cell) += share * values.transpose();
    fields_.class_mass(cell, static_cast<Index>(kind)) += share * mass;
  }
}

void ChargeFieldSums::add_contact(const Eigen::Vector3d& place, double normal_power,
                                  double shear_power, double interval) {
  const Index cell = cell_of(fields_.grid, place);
  fields_.normal_dissipation[cell] += normal_power * interval;
  fields_.shear_dissipation[cell] += shear_power * interval;
}

ChargeFields sum_of(const ChargeFields& first, const ChargeFields& second) {
  if (first.grid != second.grid || first.class_mass.cols() != second.class_mass.cols())
    throw std::logic_error("fields of two grids or charges are added");
  ChargeFields sum = first;
  sum.instants += second.instants;
  sum.sums += second.sums;
  sum.class_mass += second.class_mass;
  sum.pair_duration += second.pair_duration;
  sum.normal_dissipation += second.normal_dissipation;
  sum.shear_dissipation += second.shear_dissipation;
  return sum;
}

double interpolated(const ChargeFields& fields, FieldSum sum, const Eigen::Vector2d& place) {
  const SectionGrid& grid = fields.grid;
  const Eigen::Vector2d at = (place.array() + grid.half_width) / grid.cell_size() - 0.5;
  const auto inside = [&](double line) {
    return std::clamp(static_cast<Eigen::Index>(line), Eigen::Index{0},
                      Eigen::Index{grid.cells} - 1);
  };
  const Eigen::Vector2d low = at.array().floor();
  const Eigen::Vector2d share = at - low;
  double value = 0.0;
  for (const int right : {0, 1})
    for (const int above : {0, 1})
      value += (right == 1 ? share.x() : 1.0 - share.x()) *
               (above == 1 ? share.y() : 1.0 - share.y()) *
               fields.sums(inside(low.x() + right) + grid.cells * inside(low.y() + above),
                           static_cast<Eigen::Index>(sum));
  return value;
}

FieldMap map_of(const ChargeFields& fields) {
  const Eigen::ArrayXd mass = sum(fields, FieldSum::mass);
  const auto of_mass = [&](const auto& values) -> VectorXd {
    return (mass > 0.0).select(values.array() / mass, nan);
  };
  const auto a_volume = [&](const VectorXd& dissipation) -> VectorXd {
    const double size = fields.grid.cell_size();
    return dissipation / (fields.pair_duration * size * size * fields.slice_length);
  };
  FieldMap map;
  map.occupied = sum(fields, FieldSum::solid) / fields.instants;
  map.velocity_x = of_mass(sum(fields, FieldSum::momentum_x));
  map.velocity_z = of_mass(sum(fields, FieldSum::momentum_z));
  const VectorXd velocity_y = of_mass(sum(fields, FieldSum::momentum_y));
  const VectorXd squares = of_mass(sum(fields, FieldSum::kinetic));
  map.temperature =
      (squares - map.velocity_x.cwiseAbs2() - velocity_y.cwiseAbs2() - map.velocity_z.cwiseAbs2()) /
      3.0;
  map.normal_power = a_volume(fields.normal_dissipation);
  map.shear_power = a_volume(fields.shear_dissipation);
  map.class_share = Eigen::MatrixXd(fields.class_mass.rows(), fields.class_mass.cols());
  for (Index kind = 0; kind < fields.class_mass.cols(); ++kind)
    map.class_share.col(kind) = of_mass(fields.class_mass.col(kind));
  return map;
}

VectorXd averaged(const SectionGrid& grid, const VectorXd& values) {
  constexpr Index reach = 2;
  const Index cells = grid.cells;
  const auto table = values.reshaped(cells, cells);
  VectorXd means(values.size());
  for (Index row = 0; row < cells; ++row)
    for (Index column = 0; column < cells; ++column) {
      const Index left = std::max(column - reach, Index{0});
      const Index low = std::max(row - reach, Index{0});
      const Index right = std::min(column + reach, cells - 1);
      const Index high = std::min(row + reach, cells - 1);
      means[column + cells * row] = table.block(left, low, right - left + 1, high - low + 1).mean();
    }
  return means;
}

}  // namespace millwear::wear
