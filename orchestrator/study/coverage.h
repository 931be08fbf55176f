#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// A moment of a campaign, of several that differ in the seed of their packing alone.
struct SeedMoment {
  int seed;
  double hours;         ///< since the liner was new [h]
  double height;        ///< of the lifter [m]
  double height_error;  ///< its predicted standard error [m]
  double plate;         ///< least thickness [m]
  double plate_error;
  double volume;  ///< worn per lifter and metre of mill [m3/m]
  double volume_error;
  double roughness;  ///< of the liner (wear/surface/roughness.h) [m]
};

/// How long the liner of one campaign lasts, with its predicted 95 % band [h].
struct SeedLife {
  int seed;
  double hours;
  double low;
  double high;
};

/// Campaigns of one case that differ in the seed alone.
struct Seeds {
  std::vector<SeedMoment> moments;  ///< seed by seed, in the order of time
  std::vector<SeedLife> lives;      ///< one a seed, in the same order
};

/// A measure of several campaigns at one age: its scatter between them against what each predicts.
struct Coverage {
  std::string measure;  ///< with the unit that its values have
  double hours;         ///< age; NaN for the life
  double mean;
  double scatter;      ///< standard deviation between the campaigns
  double predicted;    ///< root mean square of the predicted standard errors
  double ratio;        ///< predicted over scatter
  double ratio_error;  ///< standard error of the ratio, of so few campaigns
};

/// Worn volume, height and plate at a quarter, a half, three quarters and the whole of the shortest
/// life, and the life. Values between two steps are linear in time; the standard error of a life is
/// that of its band. The error of the ratio takes the scatter of n campaigns to be
/// known to 1 / sqrt(2 (n - 1)), as of normal values. At least three campaigns (std::logic_error).
[[nodiscard]] std::vector<Coverage> coverage_of(const Seeds& seeds);

/// How much rougher than before a liner has become in the course of any campaign, at most [m].
[[nodiscard]] double greatest_rise_of_roughness(const std::vector<SeedMoment>& moments);

/// The table to print.
[[nodiscard]] std::string coverage_text(const std::vector<Coverage>& rows, std::size_t campaigns);

/// Campaigns as run folders, each with the seed of its locked case and with its results.
[[nodiscard]] Seeds seeds_of_runs(const std::vector<std::filesystem::path>& runs);

/// Campaigns as they are kept in a folder: `courses.csv` and `lives.csv`.
[[nodiscard]] Seeds read_seeds(const std::filesystem::path& folder);
void write_seeds(const std::filesystem::path& folder, const Seeds& seeds);

}  // namespace millwear::orchestrator
