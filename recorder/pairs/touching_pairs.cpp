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
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "recorder/liggghts/private_member.h"

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

/// A second model beside LIGGGHTS's own has its values in the same places of a contact's history.
class PlacesInHistory : public LIGGGHTS::IContactHistorySetup {
 public:
  int add_history_value(std::string /*name*/, std::string /*newtonflag*/) override {
    return next_++;
  }

 private:
  int next_ = 0;
};

std::array<double, 6> force_and_torque(const ForceData& on_particle) {
  const auto& f = on_particle.delta_F;
  const auto& t = on_particle.delta_torque;
  return {f[0], f[1], f[2], t[0], t[1], t[2]};
}

double square(const std::array<double, 3>& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

void add(double factor, const ForceData& forces, double* force, double* torque) {
  for (int k = 0; k < 3; ++k) {
    force[k] += factor * forces.delta_F[k];
    torque[k] += factor * forces.delta_torque[k];
  }
}

/// LIGGGHTS keeps a vector of all particles in one piece: where particle i's begins, without a look
/// at its table of pointers, which is memory of its own.
double* of_particle(double** vectors, int i) {
  return *vectors + 3 * static_cast<std::ptrdiff_t>(i);
}

/// A neighbour that touches.
struct Touching {
  int particle;
  int other;
  int place;  ///< of the other in the particle's list
};

constexpr std::size_t contacts_ahead = 6;  // of the forces, for memory to keep up

template <class Style>
class TouchingPairs final : private LAMMPS_NS::Pointers, public PairStyle {
 public:
  TouchingPairs(LAMMPS_NS::LAMMPS* liggghts, PairGran* pair, std::int64_t model)
      : Pointers(liggghts),
        whole_(make_whole(liggghts, pair, model)),
        model_(liggghts, &places_, false, model) {}

  static PairStyle* make(LAMMPS_NS::LAMMPS* liggghts, PairGran* pair, std::int64_t model) {
    return new TouchingPairs(liggghts, pair, model);
  }

  void settings(int count, char** options, LIGGGHTS::IContactHistorySetup* history) override {
    whole_->settings(count, options, history);
    takes_over_ = count == 0;
    if (!takes_over_) return;
    Settings defaults(lmp);
    model_.registerSettings(defaults);
    model_.postSettings(&places_);
  }

  void init_granular() override {
    whole_->init_granular();
    if (takes_over_) model_.connectToProperties(force->registry);
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
  /// Whether a step needs anything that only LIGGGHTS's own loop does.
  bool asks_for_more(PairGran& pair) {
    return !pair.computeflag() || pair.fr_pair() || pair.storeContactForcesStress() ||
           pair.storeSumDelta() || pair.store_sum_normal_force() || !pair.listgranhistory ||
           !atom->rmass || !atom->sphere_flag || force->newton_pair ||
           neighbor->contactDistanceFactor > 1 ||
           modify->n_fixes_style("insert/stream/predefined") > 0;
  }

  [[gnu::flatten]] void add_forces(PairGran& pair) {
    const bool keeps_forces =
        pair.storeContactForces() && update->ntimestep % pair.storeContactForcesEvery() == 0;
    SurfacesIntersectData contact;
    contact.computeflag = pair.computeflag();
    contact.shearupdate = pair.shearupdate();
    ForceData none;
    model_.beginPass(contact, none, none);
    find_touching(*pair.list);
    for (std::size_t n = 0; n < touching_.size(); ++n) {
      if (n + contacts_ahead < touching_.size()) fetch(pair, touching_[n + contacts_ahead]);
      describe(contact, pair, touching_[n]);
      ForceData on_i, on_j;
      model_.surfacesIntersect(contact, on_i, on_j);
      model_.endSurfacesIntersect(contact, nullptr, on_i, on_j);
      const int i = contact.i;
      const int j = contact.j;
      add(pair.relax(i), on_i, of_particle(atom->f, i), of_particle(atom->torque, i));
      if (j < atom->nlocal)
        add(pair.relax(j), on_j, of_particle(atom->f, j), of_particle(atom->torque, j));
      if (keeps_forces) keep(*pair.fix_contact_forces(), i, j, on_i, on_j);
    }
    model_.endPass(contact, none, none);
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
        count += square(between(i, j)) < reach * reach ? 1 : 0;
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

  /// From the centre of particle j to that of i [m].
  [[nodiscard]] std::array<double, 3> between(int i, int j) const {
    const double* const a = of_particle(atom->x, i);
    const double* const b = of_particle(atom->x, j);
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  void describe(SurfacesIntersectData& contact, PairGran& pair, const Touching& touching) const {
    const int i = touching.particle;
    const int j = touching.other;
    const auto delta = between(i, j);
    std::ranges::copy(delta, contact.delta);
    contact.rsq = square(delta);
    contact.radsum = atom->radius[i] + atom->radius[j];
    contact.contact_flags = &pair.listgranhistory->firstneigh[i][touching.place];
    contact.contact_history = history(pair, touching);
    contact.i = i;
    contact.j = j;
    contact.itype = atom->type[i];
    contact.jtype = atom->type[j];
    contact.radi = atom->radius[i];
    contact.radj = atom->radius[j];
    contact.v_i = of_particle(atom->v, i);
    contact.v_j = of_particle(atom->v, j);
    contact.omega_i = of_particle(atom->omega, i);
    contact.omega_j = of_particle(atom->omega, j);
    contact.r = std::sqrt(contact.rsq);
    contact.rinv = 1.0 / contact.r;
    for (int k = 0; k < 3; ++k) contact.en[k] = contact.delta[k] * contact.rinv;
    contact.mi = atom->rmass[i];
    contact.mj = atom->rmass[j];
    contact.meff = contact.mi * contact.mj / (contact.mi + contact.mj);
    if (atom->mask[i] & pair.freeze_group_bit()) contact.meff = contact.mj;
    if (atom->mask[j] & pair.freeze_group_bit()) contact.meff = contact.mi;
  }

  /// A contact across an edge of the rank is met from both sides; the first to come is kept.
  void keep(LAMMPS_NS::FixContactPropertyAtom& kept, int i, int j, const ForceData& on_i,
            const ForceData& on_j) const {
    if (kept.has_partner(i, atom->tag[j]) == -1)
      kept.add_partner(i, atom->tag[j], force_and_torque(on_i).data());
    if (kept.has_partner(j, atom->tag[i]) == -1)
      kept.add_partner(j, atom->tag[i], force_and_torque(on_j).data());
  }

  std::unique_ptr<PairStyle> whole_;
  PlacesInHistory places_;
  ContactModel<Style> model_;
  std::vector<Touching> touching_;
  bool takes_over_ = false;  ///< where the deck gives the models no options
};

template <int rolling>
void replace_loop(StyleMakers::Table& makers) {
  using Style = GranStyle<HERTZ, TANGENTIAL_HISTORY, COHESION_OFF, rolling, SURFACE_DEFAULT>;
  // LIGGGHTS has one loop for all models that its build does not list.
  const auto listed = makers.find({"gran", static_cast<int>(Style::HASHCODE)});
  const auto make = listed != makers.end()
                        ? listed->second
                        : makers.at({"gran", static_cast<int>(GranStyle<>::HASHCODE)});
  if (make == TouchingPairs<Style>::make) return;
  TouchingPairs<Style>::make_whole = make;
  makers[{"gran", static_cast<int>(Style::HASHCODE)}] = TouchingPairs<Style>::make;
}

}  // namespace

void compute_only_touching_pairs(LAMMPS_NS::LAMMPS& /*liggghts: its start filled the table*/) {
  auto& makers = Factory::instance().*member(StyleMakers{});
  replace_loop<ROLLING_CDT>(makers);
  replace_loop<ROLLING_EPSD2>(makers);
}

}  // namespace millwear::recorder
