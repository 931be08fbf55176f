#pragma once
#include <filesystem>
#include <string>

#include "mill/liner/curve_csv.h"
#include "mill/liner/liner_profile.h"

namespace millwear {

/// Nodes (xi, eta) [m] of a measured profile, a table of these columns (mill/liner/curve_csv.h).
/// Throws InputError, with file and line, where it cannot be read.
[[nodiscard]] std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file);

/// The nodes of a profile as such a file; what is read back is the same to the last bit.
[[nodiscard]] std::string profile_csv(const LinerProfile& profile);

/// Throws InputError (file:line) where a file that the program wrote ends nearer to one edge of the
/// sector than to the other, by more than `profile_end_tolerance`: a part of it is missing.
void check_has_both_ends(const CurveRows& curve, const LinerSector& sector,
                         const std::filesystem::path& file);

/// A whole pitch from a measured profile: `completed_profile` of its nodes, of those that follow
/// each other in one place the first. Throws InputError with file and line.
[[nodiscard]] LinerProfile read_profile_csv(const std::filesystem::path& file,
                                            const LinerSector& sector);

}  // namespace millwear
