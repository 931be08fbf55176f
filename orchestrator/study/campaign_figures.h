#pragma once
#include <filesystem>
#include <span>
#include <string_view>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// What a study takes from one finished campaign. NaN where it is not known. The power and what is
/// said of the charge are of the simulated slice.
struct CampaignFigures {
  double life_hours;
  double life_hours_error;
  double life_tonnes;
  double steel_per_tonne;  ///< lost, of the lifters and their plate, per metre of mill [kg/(t m)]
  double steel_per_tonne_error;
  double height;  ///< at the end [m]
  double height_error;
  double plate;  ///< least, at the end [m]
  double plate_error;
  double worn_volume;  ///< per lifter and metre of mill, at the end [m3/m]
  double worn_volume_error;
  double power;  ///< mean over the life [W]
  double power_error;
  double power_new;  ///< with the new liner [W]
  double power_new_error;
  double energy_per_tonne;  ///< per metre of mill [kWh/(t m)]
  double energy_per_tonne_error;
  double shoulder;  ///< with the new liner, from three o'clock along the rotation [degree]
  double shoulder_error;
  double toe;  ///< likewise [degree]
  double toe_error;
  double dead_zone_share;  ///< with the new liner [-]
  double dead_zone_share_error;
  double bare_hit_power;  ///< with the new liner [W]
  double bare_hit_power_error;
  double impact_power;        ///< dissipated in hits on the new liner, normal to it [W]
  double impact_half_energy;  ///< hits that dissipate more than this make half of it [J]
  double
      wear_rate_new;  ///< volume per lifter, metre of mill and hour, by the first load [m3/(m h)]
  double wear_rate_new_error;
  double rows;
  double spacing;            ///< from lifter to lifter along the new plate [m]
  double spacing_to_height;  ///< of the new lifters [-]
  double cycles;             ///< DEM loads
  double particle_steps;     ///< of the DEM: particles times time steps, mixing as planned
};

/// A figure of a campaign: its name in `study.csv`, its unit, what it is, and where it lies.
struct FigureColumn {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
  double CampaignFigures::*value;
  double CampaignFigures::*error;  ///< its standard error; nullptr where it has none
};

/// All of them, in the order of the table.
[[nodiscard]] std::span<const FigureColumn> figure_columns();

/// Wall time of all stages of a campaign [h]; it is no figure, for it differs from run to run.
[[nodiscard]] double wall_hours(const std::filesystem::path& campaign);

/// Reads the results of the campaign that a folder holds. Throws DiskError and ResultRejected.
[[nodiscard]] CampaignFigures figures_of(const std::filesystem::path& campaign, const Case& mill);

}  // namespace millwear::orchestrator
