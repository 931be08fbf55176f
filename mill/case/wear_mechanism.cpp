#include "mill/case/wear_mechanism.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mill/case/case.h"
#include "mill/case/case_units.h"

namespace millwear {
namespace {

std::string_view spoken(WearLaw law) {
  switch (law) {
    case WearLaw::archard:
      return "Archard";
    case WearLaw::finnie:
      return "Finnie";
    case WearLaw::normal_dissipation:
      return "normal dissipation";
    case WearLaw::excess_energy:
      return "excess energy of impact";
    case WearLaw::shear_dissipation:
      return "shear dissipation";
    case WearLaw::incident_energy:
      return "energy of impact";
    case WearLaw::shear_impact_energy:
      return "shear impact energy";
    case WearLaw::corrosion:
      return "corrosion";
  }
  throw std::logic_error("a wear law of no kind");
}

std::string spoken_sizes(const WearMechanism& mechanism) {
  constexpr double mm = 1e3;
  const auto& least = mechanism.least_diameter;
  const auto& most = mechanism.most_diameter;
  if (least && most) return fmt::format(" of {:g} to {:g} mm", mm * *least, mm * *most);
  if (least) return fmt::format(" of {:g} mm and more", mm * *least);
  if (most) return fmt::format(" of {:g} mm and less", mm * *most);
  return "";
}

}  // namespace

std::string_view name_of(WearLaw law) { return wear_law_names.at(static_cast<std::size_t>(law)); }

WearLaw wear_law_from(std::string_view name) {
  const auto found = std::find(wear_law_names.begin(), wear_law_names.end(), name);
  if (found == wear_law_names.end()) throw std::logic_error("no wear law " + std::string(name));
  return static_cast<WearLaw>(found - wear_law_names.begin());
}

bool concerns(const WearMechanism& mechanism, const ParticleClass& kind) {
  return mechanism.law != WearLaw::corrosion &&
         mechanism.material.value_or(kind.material) == kind.material &&
         kind.diameter >= mechanism.least_diameter.value_or(kind.diameter) &&
         kind.diameter <= mechanism.most_diameter.value_or(kind.diameter);
}

std::string spoken(const WearMechanism& mechanism, const std::vector<Material>& materials) {
  if (mechanism.law == WearLaw::corrosion) {
    return fmt::format("corrosion, {:g} mm a year",
                       1e3 * mechanism.depth_rate / depth_rate_from_m_per_year(1.0));
  }
  const std::string sizes = spoken_sizes(mechanism);
  const std::string of =
      mechanism.material ? materials.at(*mechanism.material).name : std::string("particles");
  return fmt::format("{}, k = {:g} 1/Pa{}", spoken(mechanism.law), mechanism.specific_wear_rate,
                     mechanism.material || !sizes.empty() ? ", " + of + sizes : "");
}

std::string spoken(const std::vector<WearMechanism>& mechanisms,
                   const std::vector<Material>& materials) {
  std::string text;
  for (const auto& mechanism : mechanisms) {
    text += (text.empty() ? "" : " + ") + spoken(mechanism, materials);
  }
  return text;
}

}  // namespace millwear
