#include "wear/numerics/random_stream.h"

#include <cmath>
#include <numbers>

namespace millwear::wear {
namespace {

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

/// In (0, 1): the middle of one of 2^52 equal intervals.
double uniform(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

}  // namespace

std::uint64_t random_bits(std::uint64_t seed, std::uint64_t place) {
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
  return mixed(mixed(seed) + golden * (place + 1));
}

Eigen::MatrixXd standard_normals(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed,
                                 std::uint64_t skipped) {
  std::uint64_t place = 2 * skipped;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&](Eigen::Index, Eigen::Index) {
    const double radius = std::sqrt(-2.0 * std::log(uniform(random_bits(seed, place++))));
    return radius * std::cos(2.0 * std::numbers::pi * uniform(random_bits(seed, place++)));
  });
}

}  // namespace millwear::wear
