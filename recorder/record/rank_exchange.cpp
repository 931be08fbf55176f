#include "recorder/record/rank_exchange.h"

#include <numeric>

namespace millwear::recorder {
namespace {

void sum_to_first(double* values, Eigen::Index count, MPI_Comm ranks) {
  int rank = 0;
  MPI_Comm_rank(ranks, &rank);
  MPI_Reduce(rank == 0 ? MPI_IN_PLACE : values, values, static_cast<int>(count), MPI_DOUBLE,
             MPI_SUM, 0, ranks);
}

void sum_to_first(Eigen::MatrixXd& values, MPI_Comm ranks) {
  sum_to_first(values.data(), values.size(), ranks);
}

void sum_to_first(wear::ImpactSpectrum& spectrum, MPI_Comm ranks) {
  for (auto* values : {&spectrum.normal_events, &spectrum.normal_energy, &spectrum.shear_events,
                       &spectrum.shear_energy})
    sum_to_first(*values, ranks);
  sum_to_first(spectrum.unfinished.data(), spectrum.unfinished.size(), ranks);
}

}  // namespace

std::vector<char> bytes_of_all(const std::vector<char>& mine, MPI_Comm ranks) {
  int count = 0;
  MPI_Comm_size(ranks, &count);
  const int size = static_cast<int>(mine.size());
  std::vector<int> sizes(static_cast<std::size_t>(count));
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, ranks);
  const int total = std::reduce(sizes.begin(), sizes.end());
  if (total == 0) return {};
  std::vector<int> starts(sizes.size());
  std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
  std::vector<char> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), size, MPI_BYTE, all.data(), sizes.data(), starts.data(), MPI_BYTE,
                 ranks);
  return all;
}

WallLoad sum_over_ranks(WallLoad load, MPI_Comm ranks) {
  for (auto& values : load.values) sum_to_first(values, ranks);
  sum_to_first(load.rejected.data(), std::ssize(load.rejected), ranks);
  return load;
}

wear::LinerRecord sum_over_ranks(wear::LinerRecord record, MPI_Comm ranks) {
  record.load = sum_over_ranks(std::move(record.load), ranks);
  sum_to_first(record.angles.contacts, ranks);
  sum_to_first(record.angles.normal_force, ranks);
  sum_to_first(record.spectrum, ranks);
  sum_to_first(record.triangles, ranks);
  if (record.motion)
    for (auto* values :
         {&record.motion->census, &record.motion->plate.mass, &record.motion->plate.energy,
          &record.motion->lifter.mass, &record.motion->lifter.energy})
      sum_to_first(*values, ranks);
  if (record.polar)
    for (auto& values : record.polar->values) sum_to_first(values, ranks);
  if (record.pairs) {
    sum_to_first(record.pairs->spectrum, ranks);
    sum_to_first(&record.pairs->normal_dissipation, 1, ranks);
    sum_to_first(&record.pairs->shear_dissipation, 1, ranks);
    sum_to_first(&record.pairs->rolling_dissipation, 1, ranks);
  }
  return record;
}

wear::ChargeFields sum_over_ranks(wear::ChargeFields fields, MPI_Comm ranks) {
  sum_to_first(fields.sums, ranks);
  sum_to_first(fields.class_mass, ranks);
  sum_to_first(fields.normal_dissipation.data(), fields.normal_dissipation.size(), ranks);
  sum_to_first(fields.shear_dissipation.data(), fields.shear_dissipation.size(), ranks);
  return fields;
}

std::vector<double> sums_over_ranks(const std::vector<double>& values, MPI_Comm ranks) {
  std::vector<double> sums(values.size(), 0.0);
  MPI_Allreduce(values.data(), sums.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM,
                ranks);
  return sums;
}

}  // namespace millwear::recorder
