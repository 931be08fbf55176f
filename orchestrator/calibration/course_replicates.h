#pragma once
#include <span>
#include <vector>

#include "orchestrator/calibration/course_calibration.h"
#include "wear/calibrate/course.h"

namespace millwear::orchestrator {

/// Lengths of one liner over the campaign's own hours.
struct CourseQuantities {
  wear::Course height;  ///< lifter height [m], from the new plate
  wear::Course plate;   ///< least plate thickness [m]
  wear::Course gauge;   ///< height as the gauge reads it [m]
};

/// The replicates of a campaign, each with its own factor; none where they are not known.
struct CalibratedReplicates {
  std::vector<CourseQuantities> courses;
  std::vector<double> factors;
};

/// The height as the gauge reads it.
[[nodiscard]] wear::Course as_read(const wear::Course& height, const wear::Course& plate,
                                   GaugeOn gauge);

/// Each replicate is calibrated on `heights`, to which errors are added that are drawn from theirs
/// with a fixed seed. Throws ResultRejected where the replicates are not of the history.
[[nodiscard]] CalibratedReplicates calibrated_replicates(const CampaignCourse& campaign,
                                                         std::span<const wear::DatedLength> heights,
                                                         GaugeOn gauge);

/// 95 % bands; unknown without replicates.
[[nodiscard]] wear::Band factor_band(const CalibratedReplicates& replicates);
[[nodiscard]] wear::Band band_at(const CalibratedReplicates& replicates,
                                 wear::Course CourseQuantities::*quantity, double hours);
[[nodiscard]] wear::Band life_band(const CalibratedReplicates& replicates, double height_limit);

}  // namespace millwear::orchestrator
