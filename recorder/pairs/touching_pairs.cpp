#include "recorder/pairs/touching_pairs.h"

#include <liggghts/atom.h>
#include <liggghts/contact_models.h>
#include <liggghts/fix_contact_property_atom.h>
#include <liggghts/force.h>
#include <liggghts/granular_pair_style.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/neighbor.h>
#include <liggghts/pair_gran.h>
#include <liggghts/update.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recorder/liggghts/private_member.h"
#include "recorder/pairs/hertz_contacts.h"

namespace millwear::recorder {

using Factory = LIGGGHTS::PairStyles::Factory;
using PairStyle = LIGGGHTS::PairStyles::IGranularPairStyle;
using MakeStyle = PairStyle* (*)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::PairGran*, std::int64_t);

// LIGGGHTS makes the loop over its pairs by the number of its contact model, from a private table.
struct StyleMakers {
  using Table = std::map<std::pair<std::string, int>, MakeStyle>;
  using Type = Table LIGGGHTS::Utils::AbstractFactory<PairStyle>::*;
  friend Type member(StyleMakers);
};
template struct Reach<StyleMakers, &LIGGGHTS::Utils::AbstractFactory<PairStyle>::styleTable>;

namespace {

using namespace LIGGGHTS::ContactModels;
using LAMMPS_NS::PairGran;

/// LIGGGHTS keeps a vector of all particles in one piece: where particle i's begins, without a look
/// at its table of pointers, which is memory of its own.
double* of_particle(double** vectors, int i) {
  return *vectors + 3 * static_cast<std::ptrdiff_t>(i);
}

/// What the materials of two particles make of their contact; see Contacts.
struct ContactCoefficients {
  double effective_young, effective_shear, damping, sliding_friction, rolling_friction;
};

/// The coefficients of all pairs of types, which LIGGGHTS numbers from 1, as it works them out from
/// the deck's materials.
std::vector<std::vector<ContactCoefficients>> coefficients_of_types(PropertyRegistry& registry,
                                                                    int types) {
  const auto table = [&](const char* name) {
    return registry.getMatrixProperty(name, "millwear-recorder")->data;
  };
  const auto* const* young = table("Yeff");
  const auto* const* shear = table("Geff");
  const auto* const* damping = table("betaeff");
  const auto* const* sliding = table("coeffFrict");
  const auto* const* rolling = table("coeffRollFrict");
  const auto count = static_cast<std::size_t>(types) + 1;
  std::vector coefficients(count, std::vector<ContactCoefficients>(count));
  for (std::size_t a = 1; a < count; ++a)
    for (std::size_t b = 1; b < count; ++b)
      coefficients[a][b] = {young[a][b], shear[a][b], damping[a][b], sliding[a][b], rolling[a][b]};
  return coefficients;
}

/// A neighbour that touches.
struct Touching {
  int particle;
  int other;
  int place;  ///< of the other in the particle's list
};

constexpr std::size_t contacts_ahead = 24;  // of the one gathered, for memory to keep up

template <RollingResistance rolling>
class TouchingPairs final : private LAMMPS_NS::Pointers, public PairStyle {
 public:
  TouchingPairs(LAMMPS_NS::LAMMPS* liggghts, PairGran* pair, std::int64_t model)
      : Pointers(liggghts), whole_(make_whole(liggghts, pair, model)) {}

  static PairStyle* make(LAMMPS_NS::LAMMPS* liggghts, PairGran* pair, std::int64_t model) {
    return new TouchingPairs(liggghts, pair, model);
  }

  void settings(int count, char** options, LIGGGHTS::IContactHistorySetup* history) override {
    whole_->settings(count, options, history);
    takes_over_ = count == 0;
  }

  void init_granular() override {
    whole_->init_granular();
    if (takes_over_) coefficients_ = coefficients_of_types(force->registry, atom->ntypes);
  }

  void compute_force(PairGran* pair, int energy, int virial, int add_to_compute) override {
    if (!takes_over_ || energy || virial || (pair->cpl() && add_to_compute) || asks_for_more(*pair))
      return whole_->compute_force(pair, energy, virial, add_to_compute);
    pair->evflag = pair->vflag_fdotr = 0;
    add_forces(*pair);
  }

  void write_restart_settings(FILE* file) override { whole_->write_restart_settings(file); }
  void read_restart_settings(FILE* file, std::int64_t model) override {
    whole_->read_restart_settings(file, model);
  }
  int get_history_offset(const std::string name) override {
    return whole_->get_history_offset(name);
  }
  double stressStrainExponent() override { return whole_->stressStrainExponent(); }
  std::int64_t hashcode() override { return whole_->hashcode(); }
  bool contact_match(const std::string kind, const std::string name) override {
    return whole_->contact_match(kind, name);
  }

  inline static MakeStyle make_whole = nullptr;  ///< LIGGGHTS's own loop with the same models

 private:
  static constexpr int flags = CONTACT_NORMAL_MODEL | CONTACT_TANGENTIAL_MODEL |
                               (rolling == RollingResistance::spring ? CONTACT_ROLLING_MODEL : 0);

  /// Whether a step needs anything that only LIGGGHTS's own loop does.
  bool asks_for_more(PairGran& pair) {
    return !pair.computeflag() || pair.fr_pair() || pair.storeContactForcesStress() ||
           pair.storeSumDelta() || pair.store_sum_normal_force() || !pair.listgranhistory ||
           !atom->rmass || !atom->sphere_flag || force->newton_pair ||
           neighbor->contactDistanceFactor > 1 || force->nktv2p != 1.0 ||
           modify->n_fixes_style("insert/stream/predefined") > 0;
  }

  /// Batch by batch: what the contacts need is gathered, all of them are evaluated at once, and
  /// their forces are added in LIGGGHTS's order.
  void add_forces(PairGran& pair) {
    const bool keeps_forces =
        pair.storeContactForces() && update->ntimestep % pair.storeContactForcesEvery() == 0;
    const Springs springs = pair.shearupdate() ? Springs::advance : Springs::stay;
    find_touching(*pair.list);
    for (std::size_t begin = 0; begin < touching_.size(); begin += Contacts::count) {
      const std::size_t count = std::min(Contacts::count, touching_.size() - begin);
      for (std::size_t n = 0; n < count; ++n) {
        if (begin + n + contacts_ahead < touching_.size())
          fetch(pair, touching_[begin + n + contacts_ahead]);
        describe(pair, touching_[begin + n], n);
      }
      find_hertz_forces(contacts_, rolling, update->dt, springs);
      for (std::size_t n = 0; n < count; ++n) {
        apply(pair, touching_[begin + n], n);
        if (keeps_forces) keep(*pair.fix_contact_forces(), touching_[begin + n], n);
      }
    }
    if (pair.storeContactForces()) pair.fix_contact_forces()->do_forward_comm();
  }

  /// All neighbours that touch, in LIGGGHTS's order. Listed without a branch, and before the
  /// forces: about every second neighbour touches, which no processor foresees.
  void find_touching(const LAMMPS_NS::NeighList& list) {
    std::size_t count = 0;
    for (int k = 0; k < list.inum; ++k) {
      const int i = list.ilist[k];
      const std::size_t room = count + static_cast<std::size_t>(list.numneigh[i]);
      if (touching_.size() < room) touching_.resize(2 * room);
      for (int n = 0; n < list.numneigh[i]; ++n) {
        const int j = list.firstneigh[i][n] & NEIGHMASK;
        touching_[count] = {i, j, n};
        const double reach = atom->radius[i] + atom->radius[j];
        count += square_of_distance(i, j) < reach * reach ? 1 : 0;
      }
    }
    touching_.resize(count);
  }

  /// Has the processor bring what a contact will need.
  void fetch(PairGran& pair, const Touching& touching) const {
    const int j = touching.other;
    __builtin_prefetch(of_particle(atom->x, j));
    __builtin_prefetch(of_particle(atom->v, j));
    __builtin_prefetch(of_particle(atom->omega, j));
    __builtin_prefetch(of_particle(atom->f, j), 1);
    __builtin_prefetch(of_particle(atom->torque, j), 1);
    __builtin_prefetch(history(pair, touching), 1);
  }

  static double* history(PairGran& pair, const Touching& touching) {
    return &pair.listgranhistory->firstdouble[touching.particle][pair.dnum() * touching.place];
  }

  [[nodiscard]] double square_of_distance(int i, int j) const {
    const double* const a = of_particle(atom->x, i);
    const double* const b = of_particle(atom->x, j);
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    const double z = a[2] - b[2];
    return x * x + y * y + z * z;
  }

  void describe(PairGran& pair, const Touching& touching, std::size_t n) {
    const int i = touching.particle;
    const int j = touching.other;
    const double mass_i = atom->rmass[i];
    const double mass_j = atom->rmass[j];
    contacts_.reduced_mass[n] = mass_i * mass_j / (mass_i + mass_j);
    if (atom->mask[i] & pair.freeze_group_bit()) contacts_.reduced_mass[n] = mass_j;
    if (atom->mask[j] & pair.freeze_group_bit()) contacts_.reduced_mass[n] = mass_i;
    contacts_.radius[0][n] = atom->radius[i];
    contacts_.radius[1][n] = atom->radius[j];
    const auto& of_types = coefficients_[static_cast<std::size_t>(atom->type[i])]
                                        [static_cast<std::size_t>(atom->type[j])];
    contacts_.effective_young[n] = of_types.effective_young;
    contacts_.effective_shear[n] = of_types.effective_shear;
    contacts_.damping[n] = of_types.damping;
    contacts_.sliding_friction[n] = of_types.sliding_friction;
    contacts_.rolling_friction[n] = of_types.rolling_friction;
    const double* const spring = history(pair, touching);
    for (std::size_t k = 0; k < 3; ++k) {
      contacts_.apart[k][n] = of_particle(atom->x, i)[k] - of_particle(atom->x, j)[k];
      contacts_.approach[k][n] = of_particle(atom->v, i)[k] - of_particle(atom->v, j)[k];
      contacts_.spin[0][k][n] = of_particle(atom->omega, i)[k];
      contacts_.spin[1][k][n] = of_particle(atom->omega, j)[k];
      contacts_.spring[k][n] = spring[k];
      if (rolling == RollingResistance::spring) contacts_.rolling_spring[k][n] = spring[3 + k];
    }
  }

  void apply(PairGran& pair, const Touching& touching, std::size_t n) {
    const int i = touching.particle;
    const int j = touching.other;
    pair.listgranhistory->firstneigh[i][touching.place] |= flags;
    double* const spring = history(pair, touching);
    for (std::size_t k = 0; k < 3; ++k) {
      spring[k] = contacts_.spring[k][n];
      if (rolling == RollingResistance::spring) spring[3 + k] = contacts_.rolling_spring[k][n];
      of_particle(atom->f, i)[k] += pair.relax(i) * contacts_.force[k][n];
      of_particle(atom->torque, i)[k] += pair.relax(i) * contacts_.torque[0][k][n];
    }
    if (j >= atom->nlocal) return;
    for (std::size_t k = 0; k < 3; ++k) {
      of_particle(atom->f, j)[k] -= pair.relax(j) * contacts_.force[k][n];
      of_particle(atom->torque, j)[k] += pair.relax(j) * contacts_.torque[1][k][n];
    }
  }

  /// A contact across an edge of the rank is met from both sides; the first to come is kept.
  void keep(LAMMPS_NS::FixContactPropertyAtom& kept, const Touching& touching,
            std::size_t n) const {
    const auto add_once = [&](int a, int b, double sign, const Contacts::Vectors& torque) {
      if (kept.has_partner(a, atom->tag[b]) != -1) return;
      std::array<double, 6> values;
      for (std::size_t k = 0; k < 3; ++k) {
        values[k] = sign * contacts_.force[k][n];
        values[3 + k] = torque[k][n];
      }
      kept.add_partner(a, atom->tag[b], values.data());
    };
    add_once(touching.particle, touching.other, 1.0, contacts_.torque[0]);
    add_once(touching.other, touching.particle, -1.0, contacts_.torque[1]);
  }

  std::unique_ptr<PairStyle> whole_;
  std::vector<std::vector<ContactCoefficients>> coefficients_;
  std::vector<Touching> touching_;
  Contacts contacts_{};
  bool takes_over_ = false;  ///< where the deck gives the models no options
};

template <RollingResistance rolling>
void replace_loop(StyleMakers::Table& makers) {
  constexpr int friction = rolling == RollingResistance::spring ? ROLLING_EPSD2 : ROLLING_CDT;
  using Style = GranStyle<HERTZ, TANGENTIAL_HISTORY, COHESION_OFF, friction, SURFACE_DEFAULT>;
  // LIGGGHTS has one loop for all models that its build does not list.
  const auto listed = makers.find({"gran", static_cast<int>(Style::HASHCODE)});
  const auto make = listed != makers.end()
                        ? listed->second
                        : makers.at({"gran", static_cast<int>(GranStyle<>::HASHCODE)});
  if (make == TouchingPairs<rolling>::make) return;
  TouchingPairs<rolling>::make_whole = make;
  makers[{"gran", static_cast<int>(Style::HASHCODE)}] = TouchingPairs<rolling>::make;
}

}  // namespace

void compute_only_touching_pairs(LAMMPS_NS::LAMMPS& /*liggghts: its start filled the table*/) {
  auto& makers = Factory::instance().*member(StyleMakers{});
  replace_loop<RollingResistance::constant_torque>(makers);
  replace_loop<RollingResistance::spring>(makers);
}

}  // namespace millwear::recorder
