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
             first.motion.has_value() == second.motion.has_value() &&
             first.polar.has_value() == second.polar.has_value(),
         "records that are summed are of the same mesh and the same kinds");
  LinerRecord sum = first;
  sum.load = sum_of(first.load, second.load);
  sum.angles.contacts += second.angles.contacts;
  sum.angles.normal_force += second.angles.normal_force;
  add_spectrum(sum.spectrum, second.spectrum);
  sum.triangles += second.triangles;
  if (first.pairs) sum.pairs = sum_of(*first.pairs, *second.pairs);
  if (first.motion) add_motion(*sum.motion, *second.motion);
  if (first.polar) add_polar(*sum.polar, *second.polar);
  return sum;
}

WallLoad with_blocks(const WallLoad& load, std::size_t block_count) {
  WallLoad longer = load;
  longer.block_count = block_count;
  const auto had = static_cast<Eigen::Index>(load.block_count);
  const auto blocks = static_cast<Eigen::Index>(block_count);
  const auto classes = static_cast<Eigen::Index>(load.class_count);
  for (std::size_t m = 0; m < measure_count; ++m) {
    longer.values[m].setZero(load.bins(), classes * blocks);
    for (Eigen::Index c = 0; c < classes; ++c)
      longer.values[m].middleCols(c * blocks, had) = load.values[m].middleCols(c * had, had);
  }
  return longer;
}

LinerRecord joined(const LinerRecord& first, const LinerRecord& last) {
  LinerRecord before = first;
  before.load = with_blocks(first.load, last.load.block_count);
  before.load.duration = last.load.duration;
  before.angles = with_blocks(first.angles, last.load.block_count);
  if (first.motion) before.motion = with_blocks(*first.motion, last.load.block_count);
  LinerRecord after = last;
  before.pairs.reset();
  after.pairs.reset();
  // A part that an older program measured has none, and half of a map is none either.
  if (!first.polar || !last.polar) {
    before.polar.reset();
    after.polar.reset();
  }
  LinerRecord whole = sum_of(before, after);
  whole.pairs = last.pairs ? last.pairs : first.pairs;
  whole.goal = last.goal;
  return whole;
}

}  // namespace millwear::wear
