#include "wear/record/load_accumulator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "mill/base/failure.h"
#include "tests/support/sample_measurement.h"
#include "wear/rate/wear_law.h"

namespace millwear::wear {
namespace {

/// k = 1e-12 1/Pa for both classes.
const LawWeights archard = weights_of({WearLaw::archard, 1e-12}, {{0, 0.03, 10}, {0, 0.02, 10}});

/// Places up to 1.5 mm off the profile, all around the mill.
WallContacts random_contacts(const LinerProfile& profile, double time, double mill_angle) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::size_t> node(0, profile.nodes.size() - 2);
  std::uniform_int_distribution<int> row(0, sample_sector.rows - 1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_real_distribution<double> off(-1.5e-3, 1.5e-3);
  WallContacts sample{time, mill_angle, {}};
  for (int i = 0; i < 2000; ++i) {
    const auto n = node(random);
    const Eigen::Vector2d along = profile.nodes[n + 1] - profile.nodes[n];
    const Eigen::Vector2d normal(-along.normalized().y(), along.normalized().x());
    const Eigen::Vector2d place = profile.nodes[n] + share(random) * along + off(random) * normal;
    sample.contacts.push_back(sample_contact(place, row(random), mill_angle));
    sample.contacts.back().normal_force = 1.0 + i;
    sample.contacts.back().particle = static_cast<std::size_t>(i) + 1;
  }
  return sample;
}

double sum(const WallLoad& load, Measure measure) { return load.total(measure).sum(); }

TEST(LoadAccumulator, AddsEveryMeasureToItsCellClassAndBlock) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add({1.6, 0.2, {sample_contact({0.0, 0.1}, 3, 0.2)}});
  const WallLoad load = accumulator.finish().load;
  const Eigen::Index cell = load.bins() / 2;
  const Eigen::Index last_block_of_second_class = 7;
  double found = 0.0;
  for (const Eigen::Index near : {cell - 1, cell}) {
    found += load.values[0](near, last_block_of_second_class);
  }
  EXPECT_EQ(found, 1.0);
  EXPECT_DOUBLE_EQ(sum(load, Measure::normal_impulse), 100.0 * 0.01);
  EXPECT_DOUBLE_EQ(sum(load, Measure::sliding_work), 100.0 * 0.5 * 0.01);
  EXPECT_DOUBLE_EQ(sum(load, Measure::path_work), 100.0 * 0.75 * 0.01);
  EXPECT_DOUBLE_EQ(sum(load, Measure::normal_dissipation), 100.0 * 0.2 * 0.01);
  EXPECT_DOUBLE_EQ(sum(load, Measure::shear_dissipation), 15.0 * 0.01);
  EXPECT_DOUBLE_EQ(sum(load, Measure::finnie), 3.0 * 0.01);
  EXPECT_EQ(sum(load, Measure::events), 1.0);
  EXPECT_DOUBLE_EQ(sum(load, Measure::incident_energy), 0.5 * 2.0 * 0.4 * 0.4);
  EXPECT_DOUBLE_EQ(sum(load, Measure::excess_energy), 0.5 * 2.0 * 0.3 * 0.3);
  const Eigen::MatrixXd triangles = accumulator.finish().triangles;
  EXPECT_DOUBLE_EQ(triangles(static_cast<Eigen::Index>(Measure::sliding_work), 2),
                   100.0 * 0.5 * 0.01);
  EXPECT_EQ(triangles.leftCols(2).sum(), 0.0);
}

// The measurement's samples stand for 10 ms, this one for 4 ms.
TEST(LoadAccumulator, TakesTheTimeThatASampleStandsFor) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add({0.503, 0.2, {sample_contact({0.0, 0.1}, 3, 0.2)}, 0.004});
  const WallLoad load = accumulator.finish().load;
  EXPECT_DOUBLE_EQ(sum(load, Measure::normal_impulse), 100.0 * 0.004);
  EXPECT_DOUBLE_EQ(sum(load, Measure::sliding_work), 100.0 * 0.5 * 0.004);
  EXPECT_DOUBLE_EQ(sum(load, Measure::finnie), 3.0 * 0.004);
  EXPECT_EQ(sum(load, Measure::samples), 1.0);
  EXPECT_EQ(load.by_block(Measure::samples).col(1).sum(), 1.0)
      << "0.499 ... 0.503 s has its middle in the second block, 0.493 ... 0.503 s in the first";
}

TEST(LoadAccumulator, BinsAndRejectedEqualTheTotal) {
  const LinerProfile profile = square_lifter();
  const WallContacts sample = random_contacts(profile, 0.3, 0.7);
  LoadAccumulator accumulator(profile, sample_measurement);
  accumulator.add(sample);
  double work = 0.0;
  for (const auto& contact : sample.contacts) {
    work += contact.normal_force * contact.slip_speed * sample_measurement.sample_interval;
  }
  const WallLoad load = accumulator.finish().load;
  EXPECT_GT(load.rejected[0], 400.0);
  EXPECT_EQ(sum(load, Measure::samples) + load.rejected[0], 2000.0);
  EXPECT_NEAR(sum(load, Measure::sliding_work) + load.rejected[index_of(Measure::sliding_work)],
              work, 1e-12 * work);
}

// Row 3 of ten, the mill turned by 0.2 rad: 108 and 11.46 degrees from six o'clock.
TEST(LoadAccumulator, KeepsWhereAroundTheTurnABinTakesItsLoad) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add({1.6, 0.2, {sample_contact({0.0, 0.1}, 3, 0.2)}});
  const auto polar = accumulator.finish().polar;
  ASSERT_TRUE(polar);
  const Eigen::Index column = 59;  // 115 to 120 degrees
  EXPECT_EQ(polar->values[0].col(column).sum(), 1.0);
  EXPECT_EQ(polar->values[0].sum(), 1.0);
  EXPECT_DOUBLE_EQ(polar->values[1].col(column).sum(), 100.0 * 0.2 * 0.01);
  EXPECT_DOUBLE_EQ(polar->values[2].col(column).sum(), 100.0 * 0.5 * 0.01);
}

TEST(LoadAccumulator, ThePolarLoadSumsToThatOfTheBins) {
  const LinerProfile profile = square_lifter();
  LoadAccumulator accumulator(profile, sample_measurement);
  accumulator.add(random_contacts(profile, 0.3, 0.7));
  const LinerRecord record = accumulator.finish();
  const WallLoad bins = coarsened(record.load, cells_per_bin);
  for (std::size_t m = 0; m < polar_measures.size(); ++m) {
    const Eigen::VectorXd total = bins.total(polar_measures[m]);
    EXPECT_LT((record.polar->values[m].rowwise().sum() - total).norm(), 1e-12 * total.norm());
  }
}

TEST(LoadAccumulator, RotatingEveryContactByOnePitchChangesNothing) {
  const LinerProfile profile = square_lifter();
  const double pitch = sample_sector.pitch();
  WallContacts sample = random_contacts(profile, 0.3, 0.7);
  LoadAccumulator here(profile, sample_measurement);
  here.add(sample);
  for (auto& contact : sample.contacts) {
    const double x = contact.point.x();
    const double z = contact.point.z();
    contact.point.x() = std::cos(pitch) * x + std::sin(pitch) * z;
    contact.point.z() = -std::sin(pitch) * x + std::cos(pitch) * z;
  }
  LoadAccumulator there(profile, sample_measurement);
  there.add(sample);
  const Eigen::MatrixXd difference = here.finish().load.values[index_of(Measure::sliding_work)] -
                                     there.finish().load.values[index_of(Measure::sliding_work)];
  EXPECT_LE(difference.cwiseAbs().maxCoeff(),
            1e-12 * here.finish().load.values[index_of(Measure::sliding_work)].maxCoeff());
}

// Turning the mill and its contacts together changes nothing either.
TEST(LoadAccumulator, TurnsBackByTheMillsAngle) {
  const LinerProfile profile = square_lifter();
  LoadAccumulator here(profile, sample_measurement);
  LoadAccumulator there(profile, sample_measurement);
  here.add(random_contacts(profile, 0.3, 0.0));
  there.add(random_contacts(profile, 0.3, 1.234));
  const Eigen::MatrixXd difference = here.finish().load.values[index_of(Measure::normal_impulse)] -
                                     there.finish().load.values[index_of(Measure::normal_impulse)];
  EXPECT_LE(difference.cwiseAbs().maxCoeff(),
            1e-12 * here.finish().load.values[index_of(Measure::normal_impulse)].maxCoeff());
}

// Near the sector's edge the nearest place may be on the next pitch: nothing is lost there.
TEST(LoadAccumulator, TakesContactsOnTheSectorsEdge) {
  LoadAccumulator accumulator(bare_ring(), sample_measurement);
  const double edge = 0.5 * sample_sector.pitch();
  for (const double off : {-1e-9, 0.0, 1e-9}) {
    accumulator.add({0.1, 0.0, {sample_contact(point_at(sample_sector, 1.0, edge + off), 2, 0.0)}});
  }
  EXPECT_EQ(accumulator.finish().load.rejected[0], 0.0);
  const Eigen::VectorXd samples = accumulator.finish().load.total(Measure::samples);
  EXPECT_EQ(samples[0] + samples[samples.size() - 1], 3.0);
}

// A locked sphere pressed with 100 N and dragged at 0.5 m/s for 2 s along one lifter of ten:
// V = k F s = 1e-12 * 100 N * 1 m. The law gives the rate of the mean lifter, a tenth of it.
TEST(LoadAccumulator, ADraggedContactWearsForceTimesDistance) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  for (int i = 0; i < 200; ++i) {
    const double time = 0.01 * i;
    accumulator.add({time, 0.0, {sample_contact({-0.04 + 4e-4 * i, 0.1}, 0, 0.0)}});
  }
  const WallLoad load = coarsened(accumulator.finish().load, cells_per_bin);
  const double volume_rate = depth_rate(archard, load).dot(load.bin_area());
  EXPECT_NEAR(volume_rate * 2.0 * sample_sector.rows, 1e-12 * 100.0 * 1.0, 1e-22);
}

TEST(LoadAccumulator, ARollingContactWearsNothing) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  auto contact = sample_contact({0.0, 0.1}, 0, 0.0);
  contact.slip_speed = 0.0;
  accumulator.add({0.0, 0.0, {contact}});
  EXPECT_EQ(depth_rate(archard, accumulator.finish().load).sum(), 0.0);
}

TEST(LoadAccumulator, LaysBinsAfterwards) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add(random_contacts(square_lifter(), 0.3, 0.7));
  const WallLoad bins = coarsened(accumulator.finish().load, cells_per_bin);
  EXPECT_EQ(bins.bins(), 50);
  EXPECT_EQ(bins.bin_edges[50], accumulator.finish().load.bin_edges[400]);
  EXPECT_DOUBLE_EQ(
      bins.values[index_of(Measure::sliding_work)].row(3).sum(),
      accumulator.finish().load.values[index_of(Measure::sliding_work)].middleRows(24, 8).sum());
  EXPECT_THROW(static_cast<void>(coarsened(bins, 7)), std::logic_error);
}

TEST(LoadAccumulator, RanksAddUp) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add(random_contacts(square_lifter(), 0.3, 0.7));
  const WallLoad twice = sum_of(accumulator.finish().load, accumulator.finish().load);
  EXPECT_DOUBLE_EQ(sum(twice, Measure::sliding_work),
                   2.0 * sum(accumulator.finish().load, Measure::sliding_work));
  EXPECT_EQ(twice.rejected[0], 2.0 * accumulator.finish().load.rejected[0]);
}

// What already lies there as the measurement begins is a contact, but no collision.
TEST(LoadAccumulator, WhatTouchedBeforeIsNoNewCollision) {
  std::vector<Collision> ended;
  LoadAccumulator accumulator(square_lifter(), sample_measurement,
                              [&](const Collision& c) { ended.push_back(c); });
  auto other = sample_contact({0.0, 0.1}, 0, 0.0);
  other.particle = 8;
  accumulator.begin_with({0.0, 0.0, {sample_contact({0.0, 0.1}, 0, 0.0)}});
  accumulator.add({0.01, 0.0, {sample_contact({0.0, 0.1}, 0, 0.0), other}});
  accumulator.add({0.02, 0.0, {}});
  const LinerRecord record = accumulator.finish();
  EXPECT_EQ(sum(record.load, Measure::samples), 2.0);
  EXPECT_EQ(sum(record.load, Measure::events), 1.0);
  EXPECT_DOUBLE_EQ(sum(record.load, Measure::incident_energy), 0.5 * 2.0 * 0.4 * 0.4);
  EXPECT_EQ(record.spectrum.unfinished[1], 1.0);
  EXPECT_EQ(record.spectrum.normal_events.sum(), 1.0);
  ASSERT_EQ(ended.size(), 2U);
  EXPECT_EQ(ended[0].unfinished, Unfinished::began_before);
  EXPECT_EQ(ended[1].particle, 8U);
}

// A ball that touches throughout four blocks of 0.5 s from 0.0 s on: fifty samples in each.
TEST(LoadAccumulator, EveryBlockHasItsOwnSums) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  for (int i = 0; i < 200; ++i)
    accumulator.add({0.01 * i + 0.005, 0.0, {sample_contact({0.0, 0.1}, 0, 0.0)}});
  const LinerRecord record = accumulator.finish();
  const Eigen::RowVectorXd by_block = record.load.by_block(Measure::samples).colwise().sum();
  EXPECT_EQ(by_block, Eigen::RowVectorXd::Constant(4, 50.0));
  EXPECT_EQ(record.angles.contacts.colwise().sum(), Eigen::RowVectorXd::Constant(4, 50.0));
  EXPECT_EQ(record.load.by_block(Measure::events).colwise().sum(),
            (Eigen::RowVectorXd(4) << 1.0, 0.0, 0.0, 0.0).finished());
  EXPECT_EQ(record.spectrum.unfinished[1], 1.0);
}

// Samples at 0.01, 0.02 ... 2.00 s stand for the time before them: fifty to each block of 0.5 s.
TEST(LoadAccumulator, ASampleAtTheEndOfABlockIsOfThatBlock) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  for (int i = 1; i <= 200; ++i)
    accumulator.add({0.01 * i, 0.0, {sample_contact({0.0, 0.1}, 0, 0.0)}});
  const WallLoad load = accumulator.finish().load;
  EXPECT_EQ(load.by_block(Measure::samples).colwise().sum(), Eigen::RowVectorXd::Constant(4, 50.0));
}

/// Two balls of two classes that slide along the lifter, one of them now and then in the air.
WallContacts sliding_balls(int i) {
  WallContacts sample{0.01 * i, 0.0, {sample_contact({-0.04 + 3e-4 * (i % 250), 0.1}, 0, 0.0)}};
  sample.contacts.back().normal_force = 10.0 + i % 7;
  if (i % 9 == 0) return sample;
  sample.contacts.push_back(sample_contact({0.02, 0.1}, 1, 0.0));
  sample.contacts.back().particle = 8;
  sample.contacts.back().particle_class = 0;
  return sample;
}

void expect_same(const LinerRecord& a, const LinerRecord& b) {
  EXPECT_EQ(a.load.duration, b.load.duration);
  EXPECT_EQ(a.load.block_count, b.load.block_count);
  EXPECT_EQ(a.load.values, b.load.values);
  EXPECT_EQ(a.load.rejected, b.load.rejected);
  EXPECT_EQ(a.angles.contacts, b.angles.contacts);
  EXPECT_EQ(a.angles.normal_force, b.angles.normal_force);
  EXPECT_EQ(a.spectrum.normal_events, b.spectrum.normal_events);
  EXPECT_EQ(a.spectrum.unfinished, b.spectrum.unfinished);
  EXPECT_EQ(a.triangles, b.triangles);
}

// Looked at after 2 s, on to 3 s and on to 5 s: the same bits as 5 s in ten blocks from the start.
TEST(LoadAccumulator, GoingOnIsTheSameAsALongMeasurementFromTheStart) {
  auto long_measurement = sample_measurement;
  long_measurement.duration = 5.0;
  long_measurement.block_count = 10;
  LoadAccumulator at_once(square_lifter(), long_measurement);
  LoadAccumulator bit_by_bit(square_lifter(), sample_measurement);
  for (int i = 1; i <= 500; ++i) {
    at_once.add(sliding_balls(i));
    bit_by_bit.add(sliding_balls(i));
    if (i == 200) {
      EXPECT_EQ(sum(bit_by_bit.load_so_far(), Measure::samples), 200.0 + 178.0);
      bit_by_bit.go_on_until(3.0);
    }
    if (i == 300) bit_by_bit.go_on_until(5.0);
  }
  const LinerRecord record = bit_by_bit.finish();
  EXPECT_EQ(record.load.by_block(Measure::samples).colwise().sum().minCoeff(), 50.0 + 44.0);
  expect_same(record, at_once.finish());
}

TEST(LoadAccumulator, GoesOnByWholeBlocksOnly) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  for (const double end : {1.5, 2.0, 2.3, 0.0})
    EXPECT_THROW(accumulator.go_on_until(end), InputError) << end;
  EXPECT_NO_THROW(accumulator.go_on_until(2.5));
  EXPECT_EQ(accumulator.finish().load.block_count, 5U);
}

TEST(LoadAccumulator, ACollisionOffTheProfileHasNoArcLength) {
  std::vector<Collision> ended;
  LoadAccumulator accumulator(square_lifter(), sample_measurement,
                              [&](const Collision& c) { ended.push_back(c); });
  auto off = sample_contact({0.0, 0.2}, 4, 0.0);
  off.particle = 8;
  accumulator.add({0.0, 0.0, {sample_contact({0.0, 0.1}, 3, 0.0), off}});
  accumulator.add({0.01, 0.0, {}});
  ASSERT_EQ(ended.size(), 2U);
  const auto& on = ended[ended[0].particle == 7 ? 0 : 1];
  EXPECT_NEAR(on.arc_length, 0.5 * ProfileIndex(square_lifter(), 1e-3).length(), 1e-12);
  EXPECT_EQ(on.row, 3);
  EXPECT_EQ(ended[ended[0].particle == 7 ? 1 : 0].arc_length, -1.0);
}

TEST(LoadAccumulator, RefusesTooManyContactsOffTheProfile) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  accumulator.add(
      {0.0, 0.0, {sample_contact({0.0, 0.1}, 0, 0.0), sample_contact({0.0, 0.2}, 0, 0.0)}});
  EXPECT_DOUBLE_EQ(rejected_share(accumulator.finish().load), 0.5);
  EXPECT_NO_THROW(check_rejected_share(accumulator.finish().load, 0.6));
  EXPECT_THROW(check_rejected_share(accumulator.finish().load, 0.01), ResultRejected);
}

TEST(LoadAccumulator, RefusesTimesOutsideAndValuesThatAreNoNumbers) {
  LoadAccumulator accumulator(square_lifter(), sample_measurement);
  auto contact = sample_contact({0.0, 0.1}, 0, 0.0);
  EXPECT_NO_THROW(accumulator.add({2.0, 0.0, {contact}}));
  EXPECT_THROW(accumulator.add({2.1, 0.0, {contact}}), ResultRejected);
  EXPECT_THROW(accumulator.add({-0.1, 0.0, {contact}}), ResultRejected);
  contact.particle_class = 2;
  EXPECT_THROW(accumulator.add({1.0, 0.0, {contact}}), ResultRejected);
  contact.particle_class = 1;
  contact.normal_force = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(accumulator.add({1.0, 0.0, {contact}}), ResultRejected);
  EXPECT_THROW(accumulator.begin_with({0.0, 0.0, {contact}}), ResultRejected);
  contact.normal_force = 1.0;
  contact.impact_speed = std::numeric_limits<double>::infinity();
  EXPECT_THROW(accumulator.add({1.0, 0.0, {contact}}), ResultRejected);
}

TEST(LoadAccumulator, RefusesAnEmptyMeasurement) {
  auto empty = sample_measurement;
  empty.duration = 0.0;
  EXPECT_THROW(LoadAccumulator(square_lifter(), empty), InputError);
}

}  // namespace
}  // namespace millwear::wear
