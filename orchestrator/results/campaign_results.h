#pragma once
#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "orchestrator/results/calibrated_course.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/results/replicates.h"
#include "wear/record/charge_motion.h"

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

/// One measure along the profile, a value a bin. Any vector may be empty.
struct LoadLine {
  std::vector<double> raw;             ///< as accumulated
  std::vector<double> standard_error;  ///< of `raw`, from the time blocks
  std::vector<double> smoothed;
  std::vector<double> smoothed_error;  ///< standard error of `smoothed`
};

/// The load of one cycle on the master lifter.
struct LoadAlongProfile {
  int cycle;
  std::vector<double> arc_length;        ///< of bin centres from the trailing sector edge [m]
  std::vector<double> width;             ///< of bins [m]
  std::vector<Eigen::Vector2d> centres;  ///< of bins, master frame (xi, eta) [m]
  LoadLine contacts;                     ///< contact samples per metre of profile [1/m]
  LoadLine normal_dissipation;           ///< int Fn v_n dt per lifter surface and time [W/m2]
  LoadLine sliding_work;                 ///< per lifter surface and time [W/m2]
  LoadLine depth_rate;                   ///< wear depth per running time [m/s]
};

/// Power drawn during one measurement, a value a time block.
struct PowerSeries {
  int cycle;
  std::vector<double> time;   ///< middle of the block since the measurement began [s]
  std::vector<double> power;  ///< mean over the block, of the simulated slice [W]
};

/// How often collisions of one kind dissipate how much. Rates are per second of the simulated
/// slice.
struct ImpactLine {
  std::string name;  ///< particle class, or pair of materials
  std::vector<double>
      normal;  ///< collisions by energy normal to the contact, an energy class each [1/s]
  std::vector<double> shear;  ///< by energy along the contact [1/s]
  double events_per_second;
  double normal_power;      ///< dissipated in these collisions, normal to the contact [W]
  double shear_power;       ///< along it [W]
  double unfinished_share;  ///< of all collisions, not seen whole and in none of the above [-]
  double impact_speed;      ///< root mean square [m/s]; NaN where it is not known
};

/// The collisions of one cycle.
struct Impacts {
  int cycle;
  std::vector<ImpactLine> liner;      ///< a line a particle class
  std::vector<ImpactLine> particles;  ///< a line a pair of materials; empty where not recorded
};

/// Arc of `MotionOfCycle::hit_power` [degrees].
inline constexpr Eigen::Index hit_arc_degrees = 5;

/// What the charge did in one cycle's measurement.
struct MotionOfCycle {
  int cycle;
  wear::MotionMeasures measures;
  std::vector<double> hit_power;  ///< of hits on the bare liner [W per degree], a value an arc from
                                  ///< twelve o'clock along the rotation; empty where not recorded
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

/// What a campaign tells: computed once, written to `results/`, shown by the report. Vectors are in the order of the campaign; any may be empty.
struct CampaignResults {
  std::string case_name;
  std::vector<LabelledValue> description;
  Life life;
  LinerSector sector;
  double height_limit;  ///< [m], NaN for none
  double plate_limit;   ///< [m], NaN for none
  std::vector<HistoryRow> history;
  std::vector<ProfileRow> profiles;
  std::vector<ReplicateRow> replicates{};  ///< a row for each of `history`
  std::vector<LoadAlongProfile> loads;
  std::vector<double> energy_edges;  ///< of the classes of `impacts` [J]
  std::vector<Impacts> impacts;
  std::vector<PowerSeries> power;
  std::vector<MotionOfCycle> motion{};
  std::vector<Conservation> conservation;
  std::vector<MeasuredHeight> measured;
  std::vector<MeasuredProfile> measured_profiles{};
  std::optional<CalibratedCourse> calibrated{};  ///< where the case says how far to calibrate
  std::vector<std::string> warnings;
  std::vector<LabelledValue> provenance;
};

}  // namespace millwear::orchestrator
