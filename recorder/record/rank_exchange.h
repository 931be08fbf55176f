#pragma once
#include <mpi.h>

#include <type_traits>
#include <vector>

#include "wear/charge/charge_fields.h"
#include "wear/record/liner_record.h"

namespace millwear::recorder {

/// The bytes of all ranks, in the order of the ranks. Every rank has to call it.
[[nodiscard]] std::vector<char> bytes_of_all(const std::vector<char>& mine, MPI_Comm ranks);

/// The same for plain data.
template <class Plain>
[[nodiscard]] std::vector<Plain> of_all_ranks(const std::vector<Plain>& mine, MPI_Comm ranks) {
  static_assert(std::is_trivially_copyable_v<Plain>);
  const auto* first = reinterpret_cast<const char*>(mine.data());
  const auto bytes = bytes_of_all({first, first + mine.size() * sizeof(Plain)}, ranks);
  std::vector<Plain> all(bytes.size() / sizeof(Plain));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(all.data()));
  return all;
}

/// Sum of the ranks' records, valid on rank 0. Every rank has to call it.
[[nodiscard]] wear::LinerRecord sum_over_ranks(wear::LinerRecord record, MPI_Comm ranks);

/// Sum of what the ranks saw of one charge at the same instants, valid on rank 0.
[[nodiscard]] wear::ChargeFields sum_over_ranks(wear::ChargeFields fields, MPI_Comm ranks);

/// Sums of the ranks' values, on every rank. Every rank has to call it.
[[nodiscard]] std::vector<double> sums_over_ranks(const std::vector<double>& values,
                                                  MPI_Comm ranks);

/// The same for loads alone.
[[nodiscard]] WallLoad sum_over_ranks(WallLoad load, MPI_Comm ranks);

}  // namespace millwear::recorder
