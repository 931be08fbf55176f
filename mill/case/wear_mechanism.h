#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/case/charge.h"

namespace millwear {

struct Material;

/// What the lost steel is taken to be proportional to. docs/physics.md has a section for each.
enum class WearLaw {
  archard,              ///< sliding work (Archard 1953)
  finnie,               ///< Finnie's impact integral (Finnie 1960, Cleary 1998)
  normal_dissipation,   ///< work of the normal force that does not come back (Cleary 2001)
  excess_energy,        ///< kinetic energy of impact above a speed (Cleary 2001)
  shear_dissipation,    ///< work of the friction force (Cleary 2001)
  incident_energy,      ///< kinetic energy of impact (Cleary 2001)
  shear_impact_energy,  ///< as `shear_dissipation` (Xu, Luo and Zhao 2018)
  corrosion,            ///< time alone (Radziszewski 2001)
};
inline constexpr std::array<std::string_view, 8> wear_law_names = {
    "archard",           "finnie",          "normal_dissipation",  "excess_energy",
    "shear_dissipation", "incident_energy", "shear_impact_energy", "corrosion"};

/// One term of the sum of laws that wears the liner.
struct WearMechanism {
  WearLaw law = WearLaw::archard;
  double specific_wear_rate = 0.0;         ///< volume per energy k [1/Pa]; 0 for corrosion
  double depth_rate = 0.0;                 ///< of corrosion [m/s]; 0 for all other laws
  std::optional<std::size_t> material{};   ///< only particles of this one, index of Case::materials
  std::optional<double> least_diameter{};  ///< only particles from this ... [m]
  std::optional<double> most_diameter{};   ///< ... to this diameter, both included [m]
};

[[nodiscard]] std::string_view name_of(WearLaw law);
/// The inverse of `name_of`. Throws std::logic_error for a name that is none.
[[nodiscard]] WearLaw wear_law_from(std::string_view name);

/// Whether particles of this class take part. Corrosion is of none.
[[nodiscard]] bool concerns(const WearMechanism& mechanism, const ParticleClass& kind);

/// "Archard, k = 1e-12 1/Pa, ore of 20 to 50 mm"; "corrosion, 0.1 mm a year"
[[nodiscard]] std::string spoken(const WearMechanism& mechanism,
                                 const std::vector<Material>& materials);
/// All of them, joined by " + ".
[[nodiscard]] std::string spoken(const std::vector<WearMechanism>& mechanisms,
                                 const std::vector<Material>& materials);

}  // namespace millwear
