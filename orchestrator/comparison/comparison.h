#pragma once
#include <string>
#include <vector>

#include "orchestrator/comparison/compared_campaign.h"
#include "orchestrator/comparison/differing_keys.h"

namespace millwear::orchestrator {

/// The answer of one campaign. NaN where a figure is not known. What is said of the charge is of
/// the first load, by metre of the mill's length where the length matters: slices may differ.
struct ComparedFigures {
  bool worn_out;
  double life_hours;  ///< hours so far where it is not worn out
  double life_hours_low;
  double life_hours_high;
  std::string limit;  ///< what ends the life
  double tonnes;
  double cycles;           ///< DEM loads
  double new_height;       ///< [m]
  double height;           ///< at the end [m]
  double plate_thickness;  ///< least, at the end [m]
  double worn_steel;       ///< lifters and plate over the whole circumference [kg/m]
  double worn_steel_error;
  double power;  ///< [W/m]
  double power_error;
  double bare_hit_power;  ///< [W/m]
  double bare_hit_power_error;
  double shoulder;  ///< from three o'clock on the rising side, along the rotation [degree]
  double shoulder_error;
  double toe;  ///< likewise [degree]
  double toe_error;
};

/// Campaigns side by side.
struct Comparison {
  std::vector<ComparedCampaign> campaigns;
  std::vector<ComparedFigures> figures;  ///< by campaign
  std::vector<DifferingKey> differing;
};

[[nodiscard]] Comparison comparison_of(std::vector<ComparedCampaign> campaigns);

/// The figures and the keys that differ, a column a campaign.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

/// The same as JSON, null for NaN.
[[nodiscard]] std::string comparison_json(const Comparison& comparison);

}  // namespace millwear::orchestrator
