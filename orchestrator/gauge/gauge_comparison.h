#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mill/liner/gauge_reading.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "wear/gauge/profile_comparison.h"

namespace millwear::orchestrator {

/// What a campaign says of one date: linear in time between its geometry steps.
struct Prediction {
  double lifter_height;    ///< [m]
  double face_angle;       ///< [rad]
  double plate_thickness;  ///< [m]
  double profile_hours;    ///< of the geometry step nearest in time, whose profile is compared [h]
};

/// A reading against the prediction. Differences are predicted less measured: above 0 the
/// prediction has more steel.
struct ReadingComparison {
  GaugeReading measured;
  std::optional<Prediction> predicted;                ///< none beyond the campaign's hours
  std::optional<wear::ProfileDifference> difference;  ///< none without both profiles
};

/// Compares each reading with the rows of a campaign, both in increasing order of time. Each row of
/// `history` has its profile in `profiles`. Throws ResultRejected where it has not.
[[nodiscard]] std::vector<ReadingComparison> compare_with(const std::vector<GaugeReading>& readings,
                                                          const std::vector<HistoryRow>& history,
                                                          const std::vector<ProfileRow>& profiles,
                                                          const LinerSector& sector);

/// Root mean square of the predicted less the measured heights [m]; NaN where none is compared.
[[nodiscard]] double rms_of_heights(const std::vector<ReadingComparison>& comparisons);

/// The bytes of a table `# millwear comparison 1` (docs/file_formats.md).
[[nodiscard]] std::string comparison_csv(const std::vector<ReadingComparison>& comparisons);

}  // namespace millwear::orchestrator
