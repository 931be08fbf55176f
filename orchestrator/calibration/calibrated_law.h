#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/gauge_reading.h"
#include "orchestrator/campaign/run_folder.h"
#include "wear/calibrate/calibration.h"

namespace millwear::orchestrator {

/// What became of a reading.
enum class ReadingUse {
  fitted,          ///< the coefficients were fitted to it
  shown,           ///< predicted beside a fitted one of the same reading: a profile's height
  held_out,        ///< later than asked for: predicted from the earlier ones alone
  beyond_campaign  ///< more worn than the campaign's last liner by over two errors: left out
};

/// What a reading measured. A profile's section is fitted zone by zone, and shown as its sum.
enum class MeasuredQuantity { lifter_height, plate_thickness, worn_section };

/// One measured value beside what is fitted or predicted for it; [m], of a section [m2]. NaN where
/// there is none.
struct CalibratedReading {
  double hours;
  MeasuredQuantity quantity;
  ReadingUse use;
  double measured;
  double error;
  double fitted;          ///< by the calibrated law
  double line;            ///< by the straight line: loss proportional to the hours
  double fitted_without;  ///< likewise, from all other fitted readings
  double line_without;
};

/// Root mean squares of measured less fitted over the readings of one quantity and use.
struct CalibrationRms {
  MeasuredQuantity quantity;
  ReadingUse use;
  int readings;
  double fitted;
  double line;
  double fitted_without;  ///< NaN unless every reading has it
  double line_without;
};

struct CalibratedLaw {
  Case campaign;            ///< as it was run
  Case other;               ///< with the mechanisms that were calibrated, as its file has them
  Case calibrated;          ///< with the coefficients found; mechanisms at zero are left out
  wear::Calibration found;  ///< factors on the coefficients of `other`
  std::vector<CalibratedReading> readings;
  std::vector<CalibrationRms> rms;
  bool by_section;       ///< the last readings' loss in `found.alike` is a section
  double lifter_height;  ///< of the campaign's last liner [m]
  double hours;          ///< to that liner with the law found [h]
  double elsewhere;      ///< largest share of a cycle's wear that falls elsewhere than in
                         ///< the campaign, see LawOnLoad
};

/// The coefficients of `mill`'s mechanisms from readings of its liner, along the liners and loads
/// that a finished or unfinished campaign keeps (docs/physics.md, "Calibration"). Readings later
/// than `until` [h] are predicted and not fitted; those at hour 0 are left out.
///
/// Nothing is written. Throws as `reapply`; Failure (usage) where no wear of the campaign is done
/// yet; InputError where no reading can be used or they are too few.
[[nodiscard]] CalibratedLaw calibrate(const Case& mill, const RunFolder& folder,
                                      const std::vector<GaugeReading>& readings,
                                      std::optional<double> until = {});

}  // namespace millwear::orchestrator
