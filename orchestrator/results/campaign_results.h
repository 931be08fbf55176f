#pragma once
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/liner_profile.h"
#include "orchestrator/charge/charge_of_cycle.h"
#include "orchestrator/loads/hit_power.h"
#include "orchestrator/loads/impacts.h"
#include "orchestrator/loads/load_along_profile.h"
#include "orchestrator/results/calibrated_course.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/replicates.h"
#include "wear/record/charge_motion.h"
#include "wear/record/load_store.h"

namespace millwear::orchestrator {

/// A line of a table of words.
struct LabelledValue {
  std::string label;
  std::string value;
};

/// The answer of a campaign. NaN where a figure is not known.
struct Life {
  bool reached;      ///< false while the liner is not worn out
  double hours;      ///< life [h]; hours so far where it is not reached
  double hours_low;  ///< band of the life [h]
  double hours_high;
  double tonnes;      ///< milled by then [t]
  std::string limit;  ///< what ends it, e.g. "lifter height 60 mm"
};

/// Power drawn during one measurement, a value a time block.
struct PowerSeries {
  int cycle;
  std::vector<double> time;   ///< middle of the block since the measurement began [s]
  std::vector<double> power;  ///< mean over the block, of the simulated slice [W]
};

/// What the charge did in one cycle's measurement.
struct MotionOfCycle {
  int cycle;
  wear::MotionMeasures measures;
  std::vector<double> hit_power;  ///< see orchestrator/loads/hit_power.h
};

/// The load of one cycle by angle around the turn and bin.
struct PolarLoadOfCycle {
  int cycle;
  wear::PolarLoad load;
};

/// What one cycle took from the liner against what its load accounts for.
struct Conservation {
  int cycle;
  double removed;             ///< by moving the profile [m3/m]
  double accounted;           ///< sum over bins of the wear law, and what fell off [m3/m]
  double moved_by_smoothing;  ///< share of it that smoothing carried to another place [-]
  double rejected;            ///< share of the contacts that no bin took [-]
  double revolutions;         ///< over which the load was measured
  double peak_error;  ///< relative standard error of the smoothed rate at its peaks; NaN unknown
  double path_over_slip;  ///< see `millwear::path_over_slip`
  double load_scatter;    ///< of the loads about it over what their blocks say, see `birge_ratio`
  std::string end;        ///< why the measurement ended: as `name_of(MeasurementEnd)`
};

/// A lifter height that a gauge read, to hold the prediction against.
struct MeasuredHeight {
  double operating_hours;                                   ///< [h]
  double height;                                            ///< [m]
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard error [m]
};

/// A profile that a gauge or a scan read.
struct MeasuredProfile {
  double operating_hours;              ///< [h]
  std::vector<Eigen::Vector2d> nodes;  ///< master frame (xi, eta) [m]
};

/// What a campaign tells: computed once, written to `results/`, shown by the report. Vectors are in
/// the order of the campaign; any may be empty.
struct CampaignResults {
  std::string case_name;
  std::vector<LabelledValue> description;
  Life life;
  LinerSector sector;
  double height_limit;   ///< [m], NaN for none
  double plate_limit;    ///< [m], NaN for none
  double liner_density;  ///< [kg/m3]
  std::vector<HistoryRow> history;
  std::vector<ProfileRow> profiles;
  std::vector<ReplicateRow> replicates{};  ///< a row for each of `history`
  std::vector<LoadAlongProfile> loads;
  std::vector<wear::PackedLoad> bins{};  ///< of `bins.h5`
  std::string spectrum_lines{};          ///< of `spectra.csv`
  std::vector<double> energy_edges;      ///< of the classes of `impacts` [J]
  std::vector<Impacts> impacts;
  std::vector<PowerSeries> power;
  std::vector<MotionOfCycle> motion{};
  ShownCharge charge{};                   ///< of the cycles that recorded it
  std::vector<PolarLoadOfCycle> polar{};  ///< likewise
  std::vector<Conservation> conservation;
  std::vector<MeasuredHeight> measured;
  std::vector<MeasuredProfile> measured_profiles{};
  std::optional<CalibratedCourse> calibrated{};  ///< where the case says how far to calibrate
  std::vector<std::string> warnings;
  std::vector<LabelledValue> provenance;
};

/// What the case alone tells of a campaign, before its first cycle.
[[nodiscard]] CampaignResults results_of_case(const Case& mill);

/// "lifter height 60 mm"
[[nodiscard]] std::string spoken_height_limit(const Case& mill);

}  // namespace millwear::orchestrator
