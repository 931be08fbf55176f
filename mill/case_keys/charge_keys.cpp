#include "mill/case_keys/charge_keys.h"

namespace millwear {
namespace {

using key::defaulted;
using key::in;
using key::left_to_builder;
using key::optional;
using key::required;

constexpr KeyRange filling = above_up_to(0.0, 0.9);

key::Place<Charge, double> declared(std::optional<double> DeclaredFilling::*share) {
  return {[share](Charge& charge, double value) { charge.declared.*share = value; },
          [share](const Charge& charge) { return charge.declared.*share; }};
}

}  // namespace

const std::vector<KeyRow<Material>>& material_keys() {
  static const auto rows = rows_of<Material>(
      "materials",
      {required("name", in(&Material::name), any_value, "1 to 64 of A-Z a-z 0-9 _ -"),
       required("density_kg_per_m3", in(&Material::density), positive, "density [kg/m3]"),
       required("shear_modulus_pa", in(&Material::shear_modulus), positive,
                "shear modulus as measured, before `modulus_reduction` [Pa]"),
       required("poisson_ratio", in(&Material::poisson_ratio), between(0.0, 0.499),
                "Poisson's ratio [-]"),
       optional("modulus_reduction", in(&Material::modulus_reduction), at_least(1.0),
                "this material's modulus is divided by this, in place of `modulus_reduction` of "
                "`[dem]` [-]")});
  return rows;
}

const std::vector<KeyRow<MaterialPair>>& pair_keys() {
  static const auto rows = rows_of<MaterialPair>(
      "pairs", {left_to_builder<MaterialPair>(Presence::required, KeyType::names, "materials",
                                              any_value, "the names of the two materials"),
                required("sliding_friction", in(&MaterialPair::sliding_friction),
                         between(0.0, 10.0), "coefficient of sliding friction [-]"),
                required("rolling_friction", in(&MaterialPair::rolling_friction),
                         between(0.0, 10.0), "coefficient of rolling friction [-]"),
                required("restitution", in(&MaterialPair::restitution), between(0.05, 1.0),
                         "coefficient of restitution [-]; LIGGGHTS takes none below 0.05")});
  return rows;
}

const std::vector<KeyRow<Charge>>& charge_keys() {
  static const auto rows = rows_of<Charge>(
      "charge",
      {defaulted("porosity", in(&Charge::porosity), between(0.0, 0.9),
                 "voids of the charge at rest, share of its bulk volume [-]"),
       defaulted("truncate_below_m", in(&Charge::truncate_below), at_least(0.0),
                 "sizes under this are left out; a distribution keeps its volume [m]"),
       optional("declared_total_filling", declared(&DeclaredFilling::total), filling,
                "with counts: total filling the owner declares, compared with the counts' own [-]"),
       optional("declared_ball_filling", declared(&DeclaredFilling::balls), filling,
                "with counts: ball filling the owner declares [-]"),
       left_to_builder<Charge>(
           Presence::optional, KeyType::real, "total_filling", filling,
           "bulk volume of the whole charge, share of the volume inside the plate [-]"),
       left_to_builder<Charge>(
           Presence::optional, KeyType::real, "ball_filling", filling,
           "bulk volume of the balls, part of `total_filling`; with two distributions [-]"),
       left_to_builder<Charge>(Presence::optional, KeyType::name, "ball_material", any_value,
                               "the distribution that gets `ball_filling`"),
       left_to_builder<Charge>(Presence::optional, KeyType::name, "ore_material", any_value,
                               "the distribution that gets the rest of `total_filling`")});
  return rows;
}

const std::vector<KeyRow<ParticleClass>>& count_keys() {
  static const auto rows = rows_of<ParticleClass>(
      "charge.counts",
      {left_to_builder<ParticleClass>(Presence::required, KeyType::name, "material", any_value,
                                      "material of the particles"),
       required("diameter_m", in(&ParticleClass::diameter), positive, "diameter [m]"),
       required("count", in(&ParticleClass::count), between(1, 1e8), "particles in the slice")});
  return rows;
}

const std::vector<KeyRow<SieveClass>>& distribution_keys() {
  static const auto rows = rows_of<SieveClass>(
      "charge.distributions",
      {left_to_builder<SieveClass>(Presence::required, KeyType::name, "material", any_value,
                                   "material of the particles"),
       left_to_builder<SieveClass>(
           Presence::required, KeyType::reals, "size_m", positive,
           "lower limit of each class, largest first, taken as the diameter [m]"),
       left_to_builder<SieveClass>(
           Presence::required, KeyType::reals, "retained_percent", between(0.0, 100.0),
           "share of the material's volume in each class; only the proportions count [%]")});
  return rows;
}

}  // namespace millwear
