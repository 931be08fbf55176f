#include "mill/case_keys/wear_keys.h"

#include "mill/case/case_units.h"

namespace millwear {
namespace {

using key::choice;
using key::defaulted;
using key::in;
using key::optional;

std::vector<WearLaw> wear_laws() {
  std::vector<WearLaw> laws;
  for (const std::string_view name : wear_law_names) laws.push_back(wear_law_from(name));
  return laws;
}

KeyRow<WearMechanism> law(Presence presence, std::string_view doc) {
  return choice(presence, "law", in(&WearMechanism::law), wear_laws(), doc);
}

KeyRow<WearMechanism> specific_wear_rate(std::string_view doc) {
  const key::Place<WearMechanism, double> place{
      in(&WearMechanism::specific_wear_rate).set, [](const WearMechanism& mechanism) {
        return mechanism.law == WearLaw::corrosion ? std::nullopt
                                                   : std::optional(mechanism.specific_wear_rate);
      }};
  return optional("specific_wear_rate_per_pa", place, above_up_to(0.0, 1e-6), doc);
}

KeyRow<WearMechanism> depth_rate(std::string_view doc) {
  const key::Place<WearMechanism, double> place{
      in(&WearMechanism::depth_rate).set, [](const WearMechanism& mechanism) {
        return mechanism.law == WearLaw::corrosion ? std::optional(mechanism.depth_rate)
                                                   : std::nullopt;
      }};
  return optional("depth_rate_m_per_year", converted(depth_rate_from_m_per_year, place),
                  above_up_to(0.0, 1.0), doc);
}

}  // namespace

const std::vector<KeyRow<WearMechanism>>& one_law_keys() {
  static const auto rows = rows_of<WearMechanism>(
      "wear",
      {law(Presence::defaulted, "the one law for all particles"),
       specific_wear_rate("its k: volume lost per energy of the law's measure, K/H for Archard "
                          "[1/Pa = m3/J]"),
       depth_rate("with `law = \"corrosion\"`, in place of k: depth lost everywhere [m/year of "
                  "milling]")});
  return rows;
}

const std::vector<KeyRow<WearSettings>>& wear_keys() {
  using Wear = WearSettings;
  static const auto rows = rows_of<Wear>(
      "wear",
      {defaulted("bins", in(&Wear::bins), between(100, 10000), "bins along one pitch of the liner"),
       defaulted("time_blocks", in(&Wear::time_blocks), between(2, 1000),
                 "replicates of the load in one measurement"),
       choice(Presence::defaulted, "smoothing", in(&Wear::smoothing),
              {SmoothingMethod::penalised, SmoothingMethod::paper},
              "how the load is smoothed along the profile: `penalised` as much as its "
              "noise asks for, `paper` by the two splines of the 2006 paper"),
       optional("resolution_m", in(&Wear::resolution), positive,
                "with `penalised`: waves of the load that are twice as long are halved, shorter "
                "ones go; the diameter of the smallest particle where missing [m]"),
       choice(
           Presence::defaulted, "shadowed_steel", in(&Wear::shadowed_steel),
           {ShadowedSteel::closing, ShadowedSteel::kept},
           "steel that the smallest simulated particle cannot reach: `closing` gives way with "
           "the surface that this particle touches, as smaller ones would wear it, `kept` stays"),
       defaulted("excess_speed_m_per_s", in(&Wear::excess_speed), between(0.0, 100.0),
                 "speed of impact above which the excess kinetic energy counts [m/s]")});
  return rows;
}

const std::vector<KeyRow<WearMechanism>>& mechanism_keys() {
  using Mechanism = WearMechanism;
  static const auto rows = rows_of<Mechanism>(
      "wear.mechanisms",
      {law(Presence::required, "what the loss goes with"),
       specific_wear_rate("k: volume lost per energy of the law's measure; for every law but "
                          "corrosion [1/Pa = m3/J]"),
       depth_rate("of corrosion, and only there: depth lost everywhere [m/year of milling]"),
       key::left_to_builder<Mechanism>(Presence::optional, KeyType::name, "material", any_value,
                                       "only particles of this material"),
       optional("smallest_diameter_m", in(&Mechanism::least_diameter), positive,
                "only particles of this diameter and more [m]"),
       optional("largest_diameter_m", in(&Mechanism::most_diameter), positive,
                "only particles of this diameter and less [m]")});
  return rows;
}

}  // namespace millwear
