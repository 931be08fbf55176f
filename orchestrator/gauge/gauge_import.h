#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mill/case/case.h"
#include "mill/liner/gauge_reading.h"
#include "orchestrator/gauge/gauge_curve.h"
#include "wear/gauge/alignment_fit.h"
#include "wear/gauge/profile_alignment.h"

namespace millwear::orchestrator {

/// How a gauge's curve is brought to the master lifter.
enum class AlignmentMode {
  by_file,  ///< `none` for columns xi_m, eta_m, else `fit`
  none,     ///< it is in the master frame
  ends,     ///< by its two ends
  fit,      ///< by its unworn parts
};

/// What `millwear import` was asked for.
struct ImportRequest {
  std::optional<CurveFile> curve;
  double operating_hours;  ///< [h]
  double error;            ///< standard error of the reading's lengths [m]
  AlignmentMode align;
  bool mirror;                                     ///< the curve was seen from the other end
  std::optional<double> lifter_height;             ///< [m]
  std::optional<double> plate_thickness;           ///< [m]; with a curve: where its ends lie
  std::optional<std::filesystem::path> reference;  ///< profile to fit on, in place of the new liner
  std::filesystem::path folder;                    ///< of the readings
};

/// A reading that is good to be kept.
struct ImportedReading {
  GaugeReading reading;
  std::optional<wear::AlignedCurve> alignment;
  std::optional<wear::FitQuality> fit;
  std::size_t points;                 ///< of the curve in the file
  std::vector<std::string> left_out;  ///< of a drawing
  bool replaces;                      ///< there was a reading of the same hours
  std::vector<GaugeRow> table;        ///< all rows, with this one in its place
};

/// Name of a reading's profile: profile_0005112h.csv.
[[nodiscard]] std::string profile_name(double operating_hours);

/// Reads, aligns, completes and checks a reading, against the new liner and against the other
/// readings of the folder. Writes nothing. Throws InputError, which says where and what would be
/// right.
[[nodiscard]] ImportedReading prepare_reading(const Case& mill, const ImportRequest& request);

/// Publishes the profile, where there is one, and then the table.
void publish_reading(const ImportedReading& imported, const std::filesystem::path& folder);

}  // namespace millwear::orchestrator
