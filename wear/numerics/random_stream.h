#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace millwear::wear {

/// 64 random bits that depend on a seed and a place in its stream only: the finaliser of SplitMix64
/// over a Weyl sequence. The same on every machine. Source: Steele, Lea and Flood (2014), OOPSLA,
/// "Fast splittable pseudorandom number generators".
[[nodiscard]] std::uint64_t random_bits(std::uint64_t seed, std::uint64_t place);

/// Independent standard normal numbers, rows x columns: those of the seed's stream from the place
/// 2 * `skipped` on, column by column, by the method of Box and Muller (1958), Annals of
/// Mathematical Statistics 29, 610.
[[nodiscard]] Eigen::MatrixXd standard_normals(Eigen::Index rows, Eigen::Index columns,
                                               std::uint64_t seed, std::uint64_t skipped = 0);

}  // namespace millwear::wear
