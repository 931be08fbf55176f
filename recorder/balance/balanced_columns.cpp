#include "recorder/balance/balanced_columns.h"

#include <fmt/format.h>
#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/irregular.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/update.h>
#include <mpi.h>

#include <algorithm>
#include <vector>

#include "mill/base/failure.h"
#include "recorder/balance/column_cuts.h"

namespace millwear::recorder {
namespace {

using LAMMPS_NS::LAMMPS;

constexpr std::size_t bins = 4096;

/// Particles of all ranks in even bins along the box's width, the same on every rank.
std::vector<double> counts_along_x(const LAMMPS& liggghts) {
  const auto& atom = *liggghts.atom;
  const auto& domain = *liggghts.domain;
  std::vector<double> mine(bins, 0.0);
  for (int i = 0; i < atom.nlocal; ++i) {
    const double place = (atom.x[i][0] - domain.boxlo[0]) / domain.prd[0];
    mine[static_cast<std::size_t>(std::clamp(place * bins, 0.0, bins - 1.0))] += 1.0;
  }
  std::vector<double> all(bins);
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(bins), MPI_DOUBLE, MPI_SUM,
                liggghts.world);
  return all;
}

double largest_radius(const LAMMPS& liggghts) {
  const auto& atom = *liggghts.atom;
  double mine = 0.0;
  for (int i = 0; i < atom.nlocal; ++i) mine = std::max(mine, atom.radius[i]);
  double largest = 0.0;
  MPI_Allreduce(&mine, &largest, 1, MPI_DOUBLE, MPI_MAX, liggghts.world);
  return largest;
}

/// Before the first run, the tables of contacts have no room yet for those that come from other
/// ranks.
void init_as_for_a_run(LAMMPS& liggghts) {
  constexpr int is_run = 1;
  liggghts.update->whichflag = is_run;
  liggghts.init();
  liggghts.update->whichflag = 0;
}

}  // namespace

void balance_columns(LAMMPS& liggghts, std::optional<long> columns) {
  if (!columns) return;
  auto& comm = *liggghts.comm;
  if (comm.procgrid[0] != *columns)
    throw InputError(fmt::format("--columns {}: the deck's `processors` makes {} columns along x",
                                 *columns, comm.procgrid[0]));
  init_as_for_a_run(liggghts);
  const double least_width = 2.0 * largest_radius(liggghts) / liggghts.domain->prd[0];
  const auto cuts = column_cuts(counts_along_x(liggghts), static_cast<int>(*columns), least_width);
  std::copy(cuts.begin(), cuts.end(), comm.xsplit);
  comm.uniform = 0;
  liggghts.domain->set_local_box();
  // Histories of contacts go with their particles only from the particles' own tables.
  liggghts.modify->setup_pre_exchange();
  LAMMPS_NS::Irregular(&liggghts).migrate_atoms();
}

}  // namespace millwear::recorder
