#pragma once
#include <filesystem>
#include <string>

#include "mill/liner/liner_profile.h"

namespace millwear {

/// Nodes (xi, eta) [m] of a measured profile. The file is a CSV: lines from `#` are comments, the
/// first other line names the columns, among them `xi_m` and `eta_m` in any place.
/// Throws InputError, with file and line, where it cannot be read.
[[nodiscard]] std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file);

/// The nodes of a profile as such a file; what is read back is the same to the last bit.
[[nodiscard]] std::string profile_csv(const LinerProfile& profile);

/// A whole pitch from a measured profile: `completed_profile` of its nodes. Throws InputError, with
/// file and line, for a node that is given twice.
[[nodiscard]] LinerProfile read_profile_csv(const std::filesystem::path& file,
                                            const LinerSector& sector);

}  // namespace millwear
