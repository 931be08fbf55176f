#include "wear/record/liner_record.h"

#include "mill/base/contract.h"

namespace millwear::wear {

WallLoad sum_of(const WallLoad& first, const WallLoad& second) {
  expect(first.bins() == second.bins() && first.bin_edges == second.bin_edges &&
             first.class_count == second.class_count && first.block_count == second.block_count &&
             first.rows == second.rows && first.slice_length == second.slice_length &&
             first.duration == second.duration,
         "wall loads that are summed have the same bins, classes and blocks");
  WallLoad sum = first;
  for (std::size_t m = 0; m < measure_count; ++m) {
    sum.values[m] += second.values[m];
    sum.rejected[m] += second.rejected[m];
  }
  return sum;
}

namespace {

PairRecord sum_of(PairRecord sum, const PairRecord& more) {
  expect(sum.duration == more.duration,
         "contacts between particles that are summed are of the same window");
  add_spectrum(sum.spectrum, more.spectrum);
  sum.normal_dissipation += more.normal_dissipation;
  sum.shear_dissipation += more.shear_dissipation;
  sum.rolling_dissipation += more.rolling_dissipation;
  return sum;
}

}  // namespace

LinerRecord sum_of(const LinerRecord& first, const LinerRecord& second) {
  expect(first.triangles.cols() == second.triangles.cols() &&
             first.pairs.has_value() == second.pairs.has_value() &&
             first.motion.has_value() == second.motion.has_value(),
         "records that are summed are of the same mesh and the same kinds");
  LinerRecord sum = first;
  sum.load = sum_of(first.load, second.load);
  sum.angles.contacts += second.angles.contacts;
  sum.angles.normal_force += second.angles.normal_force;
  add_spectrum(sum.spectrum, second.spectrum);
  sum.triangles += second.triangles;
  if (first.pairs) sum.pairs = sum_of(*first.pairs, *second.pairs);
  if (first.motion) add_motion(*sum.motion, *second.motion);
  return sum;
}

}  // namespace millwear::wear
