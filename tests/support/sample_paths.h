#pragma once
#include <vector>

#include "wear/calibrate/wear_path.h"

namespace millwear::wear {

/// Values at the start and the end of a piece.
struct Ends {
  double start;
  double end;
};

struct SamplePiece {
  double section;
  Ends pace;
  Ends loss;  ///< of the only zone
};

/// A path of one mechanism and one zone; height and plate lose what the zone loses.
inline WearPath one_zone_path(const std::vector<SamplePiece>& pieces) {
  WearPath path{{1}, {}, Eigen::VectorXd::Zero(3)};
  for (const auto& piece : pieces)
    path.pieces.push_back({piece.section,
                           {Eigen::VectorXd::Constant(1, piece.pace.start),
                            Eigen::MatrixXd::Constant(3, 1, piece.loss.start)},
                           {Eigen::VectorXd::Constant(1, piece.pace.end),
                            Eigen::MatrixXd::Constant(3, 1, piece.loss.end)}});
  return path;
}

/// Two mechanisms and two zones over a section of 2 m2 in eight pieces: the first wears more of
/// zone 0 and grows, the second more of zone 1 and falls. The height loses what both zones do.
inline WearPath two_mechanism_path() {
  constexpr int pieces = 8;
  const auto rates = [](double worn) {
    const double first = 0.5 + 0.5 * worn;
    const double second = 1.0 - 0.4 * worn;
    Eigen::MatrixXd losses(4, 2);
    losses << 0.8 * first, 0.3 * second, 0.2 * first, 0.7 * second, first, second, 0.0, 0.0;
    return PathRates{Eigen::Vector2d(first, second), losses};
  };
  WearPath path{{2}, {}, Eigen::Vector4d(1.0, 1.0, 2.0, 0.0)};
  const double section = 2.0 / pieces;
  for (int i = 0; i < pieces; ++i)
    path.pieces.push_back({section, rates(i * section), rates((i + 1) * section)});
  return path;
}

}  // namespace millwear::wear
