#include "wear/record/liner_record.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace millwear::wear {
namespace {

constexpr auto measures = static_cast<Eigen::Index>(measure_count);

/// Two bins, two classes, three blocks, four triangles, `value` in every place.
LinerRecord record_of(double value) {
  LinerRecord record{};
  record.load = {.slice_length = 0.25,
                 .rows = 10,
                 .duration = 2.0,
                 .bin_edges = Eigen::VectorXd::LinSpaced(3, 0.0, 0.6),
                 .class_count = 2,
                 .block_count = 3,
                 .values = {},
                 .rejected = {}};
  record.load.values.fill(Eigen::MatrixXd::Constant(2, 6, value));
  record.load.rejected.fill(value);
  record.angles = {Eigen::MatrixXd::Constant(degrees_around, 3, value),
                   Eigen::MatrixXd::Constant(degrees_around, 3, value)};
  record.spectrum = empty_spectrum(2);
  add_collision(record.spectrum, 1, value, value);
  record.triangles = Eigen::MatrixXd::Constant(measures, 4, value);
  record.motion = no_charge_motion(3);
  record.motion->census.setConstant(value);
  add_hit(record.motion->plate, 0.2, value, value, 1);
  add_hit(record.motion->lifter, 0.2, value, value, 2);
  record.polar = no_polar_load(2);
  for (auto& values : record.polar->values) values.setConstant(value);
  record.pairs = PairRecord{0.5, empty_spectrum(3), value, 2.0 * value, 3.0 * value};
  return record;
}

TEST(LinerRecord, RanksAddUp) {
  const LinerRecord sum = sum_of(record_of(1.0), record_of(4.0));
  for (std::size_t m = 0; m < measure_count; ++m) {
    EXPECT_EQ(sum.load.values[m], Eigen::MatrixXd::Constant(2, 6, 5.0));
    EXPECT_EQ(sum.load.rejected[m], 5.0);
  }
  EXPECT_EQ(sum.angles.contacts, Eigen::MatrixXd::Constant(degrees_around, 3, 5.0));
  EXPECT_EQ(sum.angles.normal_force, Eigen::MatrixXd::Constant(degrees_around, 3, 5.0));
  EXPECT_EQ(sum.spectrum.normal_events.sum(), 2.0);
  EXPECT_EQ(sum.spectrum.normal_energy.sum(), 5.0);
  EXPECT_EQ(sum.triangles, Eigen::MatrixXd::Constant(measures, 4, 5.0));
  EXPECT_EQ(sum.pairs->duration, 0.5);
  EXPECT_EQ(sum.pairs->normal_dissipation, 5.0);
  EXPECT_EQ(sum.pairs->shear_dissipation, 10.0);
  EXPECT_EQ(sum.pairs->rolling_dissipation, 15.0);
  EXPECT_EQ(sum.motion->census, Eigen::MatrixXd::Constant(6, 3, 5.0));
  EXPECT_EQ(sum.motion->plate.mass.col(1).sum(), 5.0);
  EXPECT_EQ(sum.motion->plate.energy.sum(), 5.0);
  EXPECT_EQ(sum.motion->lifter.mass.col(2).sum(), 5.0);
  EXPECT_EQ(sum.motion->lifter.energy.sum(), 5.0);
  for (const auto& values : sum.polar->values)
    EXPECT_EQ(values, Eigen::MatrixXd::Constant(2, polar_columns, 5.0));
  EXPECT_EQ(sum.load.duration, 2.0);
  EXPECT_EQ(sum.load.rows, 10);
}

TEST(LinerRecord, RefusesToSumWhatDiffersInMoreThanItsValues) {
  const std::function<void(LinerRecord&)> changes[] = {
      [](LinerRecord& r) { r.load.rows = 11; },
      [](LinerRecord& r) { r.motion.reset(); },
      [](LinerRecord& r) { r.polar.reset(); },
      [](LinerRecord& r) { r.load.duration = 3.0; },
      [](LinerRecord& r) { r.load.slice_length = 0.5; },
      [](LinerRecord& r) { r.load.bin_edges[1] = 0.2; },
      [](LinerRecord& r) { r.load.bin_edges.conservativeResize(2); },
      [](LinerRecord& r) { r.load.class_count = 3; },
      [](LinerRecord& r) { r.load.block_count = 2; },
      [](LinerRecord& r) { r.triangles.conservativeResize(measures, 3); },
      [](LinerRecord& r) { r.pairs.reset(); },
      [](LinerRecord& r) { r.pairs->duration = 0.6; }};
  for (const auto& change : changes) {
    LinerRecord other = record_of(1.0);
    change(other);
    EXPECT_THROW(static_cast<void>(sum_of(record_of(1.0), other)), std::logic_error)
        << &change - changes;
  }
}

// The first part knows three blocks, the last, by which the measurement went on, four.
TEST(LinerRecord, PartsJoinWithTheBlocksOfTheLast) {
  LinerRecord last = record_of(4.0);
  last.load = with_blocks(last.load, 4);
  last.load.duration = 8.0 / 3.0;
  last.angles = with_blocks(last.angles, 4);
  last.motion = with_blocks(*last.motion, 4);
  last.pairs.reset();
  const LinerRecord whole = joined(record_of(1.0), last);
  EXPECT_EQ(whole.load.block_count, 4U);
  EXPECT_EQ(whole.load.duration, 8.0 / 3.0);
  const auto& values = whole.load.values[0];
  ASSERT_EQ(values.cols(), 8);  // two classes
  EXPECT_EQ(values.leftCols(3), Eigen::MatrixXd::Constant(2, 3, 5.0));
  EXPECT_EQ(values.col(3).sum(), 0.0);
  EXPECT_EQ(values.middleCols(4, 3), Eigen::MatrixXd::Constant(2, 3, 5.0));
  EXPECT_EQ(whole.angles.contacts.leftCols(3), Eigen::MatrixXd::Constant(degrees_around, 3, 5.0));
  EXPECT_EQ(whole.motion->census.leftCols(3), Eigen::MatrixXd::Constant(6, 3, 5.0));
  ASSERT_TRUE(whole.pairs);
  EXPECT_EQ(whole.pairs->normal_dissipation, 1.0);
  EXPECT_EQ(whole.polar->values[2], Eigen::MatrixXd::Constant(2, polar_columns, 5.0));
}

TEST(LinerRecord, APartWithoutAPolarLoadLeavesTheWholeWithoutOne) {
  LinerRecord older = record_of(1.0);
  older.polar.reset();
  EXPECT_FALSE(joined(older, record_of(4.0)).polar);
  EXPECT_FALSE(joined(record_of(4.0), older).polar);
}

}  // namespace
}  // namespace millwear::wear
