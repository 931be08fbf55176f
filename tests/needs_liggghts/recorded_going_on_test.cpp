#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "liggghts_inputs/decks/deck.h"
#include "mill/case/time_step.h"
#include "tests/needs_liggghts/mill_trial.h"
#include "wear/rate/load_rate.h"
#include "wear/rate/smoothing_error.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

constexpr int blocks = 10;
constexpr long piece_blocks = 2;
constexpr double never = 1e-9;

/// A deck of ten blocks, and how its measurement is to go on.
struct Measuring {
  std::string stage;
  double target = never;
  long most_blocks = blocks;
  long pair_steps = 0;
  int ranks = 1;
  long settle_steps = 500;
};

class GoingOn : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
    mix(mill_, {plan_.time_step, 3 * plan_.steps_per_pitch, 0, 20}, scratch_.stage("mix"), 1);
  }

  [[nodiscard]] Recording until_known(const Measuring& stretch, long steps_of_block) const {
    Case mill = mill_;
    mill.wear.time_blocks = blocks;
    mill.dem.error_target = ErrorTarget{stretch.target, mill.dem.measure_revolutions};
    StretchSteps steps{plan_.time_step, stretch.settle_steps, blocks * steps_of_block, 1,
                       stretch.pair_steps};
    steps.go_on_steps = piece_blocks * steps_of_block;
    steps.most_measure_steps = stretch.most_blocks * steps_of_block;
    return record(mill, steps, mill.liner, scratch_.stage(stretch.stage), "mix", stretch.ranks);
  }

  /// The same deck, written for so many blocks from the start.
  [[nodiscard]] Recording at_once(const Measuring& stretch, long steps_of_block) const {
    Case mill = mill_;
    mill.wear.time_blocks = static_cast<int>(stretch.most_blocks);
    const StretchSteps steps{plan_.time_step, stretch.settle_steps,
                             stretch.most_blocks * steps_of_block, 1, stretch.pair_steps};
    return record(mill, steps, mill.liner, scratch_.stage(stretch.stage), "mix", stretch.ranks);
  }

  [[nodiscard]] std::string file_of(const std::string& stage, const char* name) const {
    return text_of(scratch_.stage(stage) / name);
  }

  Case mill_ = small_mill(ContactPath::recorder);
  const StepPlan plan_ = plan_steps(mill_);
  const ScratchFolder scratch_;
};

/// The first `count` time blocks of a load.
WallLoad first_blocks(const WallLoad& load, long count) {
  WallLoad part = load;
  part.block_count = static_cast<std::size_t>(count);
  part.duration *= static_cast<double>(count) / static_cast<double>(load.block_count);
  const auto classes = static_cast<Eigen::Index>(load.class_count);
  const auto all = static_cast<Eigen::Index>(load.block_count);
  for (std::size_t m = 0; m < measure_count; ++m) {
    part.values[m].resize(load.bins(), classes * count);
    for (Eigen::Index c = 0; c < classes; ++c)
      part.values[m].middleCols(c * count, count) = load.values[m].middleCols(c * all, count);
  }
  return part;
}

double error_of(const Case& mill, const WallLoad& load) {
  return wear::peak_error(
      wear::rate_of_load(mill.wear, mill.charge.classes, mill.liner, load).smoothed);
}

void expect_same(const Recording& a, const Recording& b) {
  EXPECT_EQ(a.record.load.duration, b.record.load.duration);
  EXPECT_EQ(a.record.load.block_count, b.record.load.block_count);
  EXPECT_TRUE(a.record.load.values == b.record.load.values);
  EXPECT_EQ(a.record.load.rejected, b.record.load.rejected);
  EXPECT_TRUE(a.record.angles.contacts == b.record.angles.contacts);
  EXPECT_TRUE(a.record.angles.normal_force == b.record.angles.normal_force);
  EXPECT_TRUE(a.record.spectrum.normal_events == b.record.spectrum.normal_events);
  EXPECT_TRUE(a.record.spectrum.shear_energy == b.record.spectrum.shear_energy);
  EXPECT_TRUE(a.record.spectrum.unfinished == b.record.spectrum.unfinished);
  EXPECT_TRUE(a.record.triangles == b.record.triangles);
  EXPECT_TRUE(a.record.motion->census == b.record.motion->census);
  EXPECT_TRUE(a.record.motion->plate.energy == b.record.motion->plate.energy);
  EXPECT_TRUE(a.record.motion->lifter.mass == b.record.motion->lifter.mass);
}

// Where the target is out of reach it measures as long as it may, and then all that was recorded,
// and the charge it leaves, are those of a deck that was that long from the start, to the last bit.
TEST_F(GoingOn, IsTheSameAsALongDeck) {
  const Measuring stretch{.stage = "bit_by_bit", .most_blocks = 14};
  const auto bit_by_bit = until_known(stretch, 300);
  ASSERT_TRUE(bit_by_bit.record.goal);
  EXPECT_EQ(bit_by_bit.record.goal->target_error, never);
  EXPECT_EQ(bit_by_bit.record.goal->peak_error, error_of(mill_, bit_by_bit.record.load));
  EXPECT_EQ(bit_by_bit.record.load.block_count, 14U);
  const std::string log = file_of(stretch.stage, liggghts::file_names::log);
  EXPECT_NE(log.find("going on to step 4100, perhaps to 4700"), std::string::npos) << log;

  const auto whole = at_once({.stage = "at_once", .most_blocks = 14}, 300);
  expect_same(bit_by_bit, whole);
  EXPECT_TRUE(file_of(stretch.stage, "events.h5") == file_of("at_once", "events.h5"));
  EXPECT_TRUE(file_of(stretch.stage, liggghts::file_names::restart) ==
              file_of("at_once", liggghts::file_names::restart));
}

// It ends with the first piece after which the target is reached, and says how well it knows.
TEST_F(GoingOn, EndsWhereTheTargetIsReached) {
  const auto longest = at_once({.stage = "longest", .most_blocks = 26}, 300).record.load;
  long expected = blocks;
  double target = 1.0;
  for (long count = blocks; count <= 26; count += piece_blocks) {
    const double error = error_of(mill_, first_blocks(longest, count));
    RecordProperty(fmt::format("error_after_{}_blocks", count), fmt::format("{:.4f}", error));
    if (error >= target) continue;
    target = error;
    expected = count;
  }
  ASSERT_GT(expected, blocks) << "the first blocks are the best; take others";

  const auto reached =
      until_known({.stage = "reached", .target = 1.000001 * target, .most_blocks = 32}, 300);
  EXPECT_EQ(reached.record.load.block_count, static_cast<std::size_t>(expected));
  EXPECT_TRUE(reached.record.load.values == first_blocks(longest, expected).values);
  ASSERT_TRUE(reached.record.goal);
  EXPECT_TRUE(wear::is_reached(*reached.record.goal));
}

// The collisions between particles stay in the window that the deck has for them, and a target that
// is reached at once changes nothing.
TEST_F(GoingOn, LeavesTheWindowOfTheParticlesAlone) {
  const auto plain = at_once({.stage = "plain", .pair_steps = 400}, 100);
  const auto easy = until_known({.stage = "easy", .target = 1.0, .pair_steps = 400}, 100);
  const auto on =
      until_known({.stage = "on", .most_blocks = blocks + piece_blocks, .pair_steps = 400}, 100);
  expect_same(plain, easy);
  EXPECT_FALSE(plain.record.goal);
  EXPECT_TRUE(easy.record.goal);
  EXPECT_EQ(on.record.load.block_count, 12U);
  for (const auto* const other : {&easy, &on}) {
    EXPECT_EQ(other->record.pairs->duration, plain.record.pairs->duration);
    EXPECT_EQ(other->record.pairs->spectrum.normal_events,
              plain.record.pairs->spectrum.normal_events);
    EXPECT_EQ(other->record.pairs->shear_dissipation, plain.record.pairs->shear_dissipation);
  }
}

// Two ranks decide as one, on the sum of what they saw; going on, they see what a long deck sees.
TEST_F(GoingOn, IsDecidedOnWhatAllRanksSaw) {
  const auto on = until_known({.stage = "on", .most_blocks = 14, .ranks = 2}, 20);
  expect_same(on, at_once({.stage = "at_once", .most_blocks = 14, .ranks = 2}, 20));
  EXPECT_EQ(on.record.load.block_count, 14U);
  EXPECT_EQ(on.record.goal->peak_error, error_of(mill_, on.record.load));
}

// The trajectories of one rank and of two drift apart, but not within some dozen steps.
TEST_F(GoingOn, IsTheSameOnOneRankAndOnTwo) {
  const Measuring stretch{.stage = "one", .most_blocks = 14, .settle_steps = 10};
  const auto one = until_known(stretch, 2).record;
  auto on_two = stretch;
  on_two.stage = "two";
  on_two.ranks = 2;
  const auto two = until_known(on_two, 2).record;
  EXPECT_EQ(one.load.block_count, 14U);
  EXPECT_EQ(two.load.block_count, 14U);
  EXPECT_EQ(one.load.duration, two.load.duration);
  EXPECT_NEAR(one.goal->peak_error, two.goal->peak_error, 1e-6 * one.goal->peak_error);
  for (std::size_t m = 0; m < measure_count; ++m) {
    const double all = one.load.values[m].cwiseAbs().sum();
    EXPECT_LE((one.load.values[m] - two.load.values[m]).cwiseAbs().sum(), 1e-6 * all)
        << measure_names[m];
  }
  EXPECT_EQ(one.angles.contacts.sum(), two.angles.contacts.sum());
  EXPECT_GT(one.motion->census.sum(), 0.0);
  EXPECT_LE((one.motion->census - two.motion->census).cwiseAbs().maxCoeff(),
            1e-6 * one.motion->census.maxCoeff());
  EXPECT_NEAR(one.motion->lifter.energy.sum(), two.motion->lifter.energy.sum(),
              1e-6 * one.motion->lifter.energy.sum());
}

}  // namespace
}  // namespace millwear::trial
