#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mill/liner/liner_profile.h"
#include "orchestrator/campaign/campaign.h"
#include "wear/charge/charge_frames.h"
#include "wear/charge/charge_landmarks.h"

namespace millwear::orchestrator {

/// A field over the mill's section.
struct SectionMap {
  std::string name;
  std::string unit;
  Eigen::VectorXd values;  ///< by cell of the grid; NaN where no particle came
};

/// How the charge looked in the measurement of one cycle, in the frame at rest.
struct ChargeOfCycle {
  int cycle;
  double speed;        ///< of the mill [rad/s]
  LinerProfile liner;  ///< that it lay on, as the DEM turns it
  wear::SectionGrid grid;
  /// Those of `wear::FieldMap`, `mean_diameter` [m] and, of several materials, `share_of_MATERIAL`
  /// of the mass.
  std::vector<SectionMap> maps;
  wear::ChargeLandmarks landmarks;
  std::optional<wear::ChargeFrames> frames;       ///< of the first, the middle and the last cycle
  std::map<std::string, std::string> pictures{};  ///< JPEG by name, as far as they are drawn
};

/// A particle class by its names.
struct ShownClass {
  std::string name;
  std::string material;
  double diameter;  ///< [m]
  double density;   ///< [kg/m3]
};

/// The charge of a campaign.
struct ShownCharge {
  std::vector<ShownClass> classes;
  double slice_length = 0.0;  ///< [m]
  /// At the end of the scale of pictures [m/s]: three quarters of the speed after a fall through
  /// the mill, sqrt(2 g D), rounded. So the colours of all cycles mean the same.
  double fastest = 0.0;
  std::vector<ChargeOfCycle> cycles;
};

/// The charge of these cycles, without those that have no `charge.h5`: older programs wrote none.
/// Throws DiskError, and ResultRejected where a file is damaged.
[[nodiscard]] ShownCharge charge_of_cycles(const Campaign& campaign,
                                           const std::vector<int>& cycles);

/// The map of that name (std::logic_error without one).
[[nodiscard]] const SectionMap& map_named(const ChargeOfCycle& charge, std::string_view name);

}  // namespace millwear::orchestrator
