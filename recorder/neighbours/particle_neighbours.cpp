#include "recorder/neighbours/particle_neighbours.h"

#include <liggghts/atom.h>
#include <liggghts/error.h>
#include <liggghts/fix_contact_history.h>
#include <liggghts/neigh_list.h>
#include <liggghts/update.h>

#include <algorithm>
#include <cstdint>

namespace millwear::recorder {
namespace {

using LAMMPS_NS::FixContactHistory;
using LAMMPS_NS::NeighList;

/// Where LIGGGHTS keeps what a contact has remembered since it began: a flag a neighbour, and the
/// values of those that touch.
class ContactMemory {
 public:
  explicit ContactMemory(NeighList& list)
      : fix_(list.fix_history), list_(fix_ == nullptr ? nullptr : list.listgranhistory) {
    if (list_ == nullptr) return;
    list_->ipage->reset();
    list_->dpage->reset();
  }

  void begin_particle() {
    if (list_ == nullptr) return;
    flags_ = list_->ipage->vget();
    values_ = list_->dpage->vget();
  }

  void add_neighbour(int n, int i, int tag, bool touches) {
    if (list_ == nullptr) return;
    const int width = list_->dnum;
    const double* const kept = touches ? values_with(i, tag) : nullptr;
    flags_[n] = kept != nullptr ? 1 : 0;
    double* const values = values_ + static_cast<std::ptrdiff_t>(n) * width;
    if (kept != nullptr)
      std::copy_n(kept, width, values);
    else
      std::fill_n(values, width, 0.0);
  }

  void end_particle(int i, int neighbours) {
    if (list_ == nullptr) return;
    list_->firstneigh[i] = flags_;
    list_->firstdouble[i] = values_;
    list_->ipage->vgot(neighbours);
    list_->dpage->vgot(neighbours * list_->dnum);
  }

 private:
  [[nodiscard]] const double* values_with(int i, int tag) const {
    for (int m = 0; m < fix_->n_partner(i); ++m)
      if (fix_->partner(i, m) == tag) return fix_->contacthistory(i, m);
    return nullptr;
  }

  FixContactHistory* fix_;
  NeighList* list_;
  int* flags_ = nullptr;
  double* values_ = nullptr;
};

}  // namespace

ParticleNeighbours::ParticleNeighbours(LAMMPS_NS::LAMMPS* liggghts) : Neighbor(liggghts) {}

void ParticleNeighbours::choose_build(int index, LAMMPS_NS::NeighRequest* request) {
  Neighbor::choose_build(index, request);
  const bool serves = pair_build[index] == &ParticleNeighbours::granular_bin_no_newton &&
                      exclude == 0 && includegroup == 0;
  if (serves) pair_build[index] = static_cast<PairPtr>(&ParticleNeighbours::build_by_size);
}

const SizeGrids* ParticleNeighbours::grids_of_this_step() const {
  return grids_ && built_at_ == update->ntimestep ? &*grids_ : nullptr;
}

std::uint64_t ParticleNeighbours::order_by_columns(int particle) const {
  const int bin = bin_of_[particle];
  const int ix = bin % mbinx, iy = bin / mbinx % mbiny, iz = bin / mbinx / mbiny;
  return (std::uint64_t(ix) * mbiny + iy) * mbinz + iz;
}

void ParticleNeighbours::note_bins() {
  bin_of_.resize(static_cast<std::size_t>(atom->nlocal) + atom->nghost);
  for (int bin = 0; bin < mbins; ++bin)
    for (int i = binhead[bin]; i >= 0; i = bins[i]) bin_of_[i] = bin;
}

void ParticleNeighbours::build_by_size(NeighList* list) {
  bin_atoms();  // triangles look for their particles there
  note_bins();
  const double* const* const x = atom->x;
  const double* const radius = atom->radius;
  grids_.emplace(Spheres{x, {radius, bin_of_.size()}}, NeighbourReach{skin, contactDistanceFactor});
  built_at_ = update->ntimestep;
  list->ipage->reset();
  ContactMemory remembered(*list);

  for (int i = 0; i < atom->nlocal; ++i) {
    near_.clear();
    grids_->add_later_neighbours(i, near_);
    if (static_cast<int>(near_.size()) >= oneatom)
      error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
    // LIGGGHTS goes through bins and through numbers within a bin, both upwards.
    ordered_.clear();
    for (const int j : near_) ordered_.emplace_back(bin_of_[j], j);
    std::sort(ordered_.begin(), ordered_.end());

    int* const neighbours = list->ipage->vget();
    remembered.begin_particle();
    int n = 0;
    for (const auto& [bin, j] : ordered_) {
      const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
      const double touching = (radius[i] + radius[j]) * contactDistanceFactor;
      neighbours[n] = j;
      remembered.add_neighbour(n, i, atom->tag[j],
                               dx * dx + dy * dy + dz * dz < touching * touching);
      ++n;
    }
    list->ilist[i] = i;
    list->firstneigh[i] = neighbours;
    list->numneigh[i] = n;
    list->ipage->vgot(n);
    remembered.end_particle(i, n);
  }
  list->inum = atom->nlocal;
  if (list->ipage->status() != 0)
    error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
}

}  // namespace millwear::recorder
