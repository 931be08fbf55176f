#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/gauge_reading.h"
#include "orchestrator/results/calibrated_course.h"
#include "orchestrator/results/campaign_results.h"

namespace millwear::orchestrator {

/// What a campaign says of its liner over time.
struct CampaignCourse {
  std::vector<HistoryRow> history;
  std::vector<ReplicateRow> replicates;  ///< a row for each of `history`; empty where not known
};

/// How a campaign is to be held against readings.
struct CourseCalibration {
  double until;  ///< calibrate on the readings up to these operating hours [h]
  GaugeOn gauge_on = GaugeOn::new_plate;
};

/// Calibrates the campaign's hours on the heights read up to `how.until` (`wear::factor_of`) and
/// holds it, and the straight line of the same readings, against all of them. The bands: each
/// replicate is calibrated by itself, on the same readings with errors drawn from theirs; what is
/// left is its spread. A replicate goes on after its last liner as fast as all of them did
/// (`wear::mean_speed`); the prediction itself never does. `readings` are in the order of time.
/// Throws InputError where no height can be calibrated on (none between 0 and `until`, none that
/// shows wear, or all deeper than the campaign's last liner), and ResultRejected where the
/// replicates are not of the history.
[[nodiscard]] CalibratedCourse calibrated_course(const Case& mill, const CampaignCourse& campaign,
                                                 const std::vector<GaugeReading>& readings,
                                                 const CourseCalibration& how);

/// Gives the report the calibrated course where the case says how far to calibrate; where that
/// cannot be done yet, a warning.
void add_calibrated_course(const Case& mill, const std::vector<GaugeReading>& readings,
                           CampaignResults& data);

}  // namespace millwear::orchestrator
