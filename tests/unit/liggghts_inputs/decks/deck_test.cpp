#include "liggghts_inputs/decks/deck.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "mill/load/steady_mixing.h"
#include "tests/support/example_case.h"

namespace millwear::liggghts {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const StretchSteps steps{4e-5, 4000, 20000, 20};

std::string liner_deck(StretchKind kind, int cycle, int chunk = 0) {
  return contact_model_deck(example_case(), steps, {"liner.stl", 216}, {kind, cycle, chunk});
}

TEST(Deck, LeavesNoPlaceholderBehind) {
  const Case mill = example_case();
  for (const auto& deck : {mixing_deck(mill, steps, {}, 1),
                           measuring_deck(mill, steps, mill.liner, "../mix/charge.restart", 1),
                           trial_deck(mill, {25, 100}, "../mix/charge.restart", 1),
                           liner_deck(StretchKind::mix, 0), liner_deck(StretchKind::measure, 3)}) {
    EXPECT_THAT(deck, Not(HasSubstr("{{")));
    EXPECT_THAT(deck, Not(HasSubstr("}}")));
  }
}

// 4000 steps of settling, then 20,010 steps with a sample every 20: the last is 10 steps behind the
// one before. LIGGGHTS asks the formula for the step that follows a sample.
TEST(Deck, DumpsTheBeginningAndTheEndOfTheMeasurement) {
  Case mill = example_case();
  mill.dem.contact_path = ContactPath::dumps;
  const auto deck = measuring_deck(mill, {4e-5, 4000, 20010, 20}, mill.liner, "x", 1);
  EXPECT_THAT(deck, HasSubstr("\nvariable      steps_left equal 24010-step\n"));
  EXPECT_THAT(deck,
              HasSubstr("equal step+20-(v_steps_left>0)*(v_steps_left<20)*(20-v_steps_left)\n"));
  EXPECT_THAT(deck, HasSubstr("dump_modify   contacts first yes every v_next_sample "));
  EXPECT_THAT(deck, HasSubstr("dump_modify   spins first yes every v_next_sample "));
}

TEST(Deck, PrintsTheSentinelLast) {
  const Case mill = example_case();
  const std::string end = "print         \"millwear: stretch complete\"\n";
  EXPECT_THAT(mixing_deck(mill, steps, {}, 1), EndsWith(end));
  EXPECT_THAT(measuring_deck(mill, steps, mill.liner, "x", 1), EndsWith(end));
}

TEST(Deck, CutsTheChargeInTwoForAnEvenNumberOfRanks) {
  const Case mill = example_case();
  for (const auto& deck : {mixing_deck(mill, steps, {}, 4), trial_deck(mill, {25, 100}, "x", 2),
                           measuring_deck(mill, steps, mill.liner, "x", 2)})
    EXPECT_THAT(deck, HasSubstr("\nprocessors    2 * 1\n"));
  for (const auto& deck : {mixing_deck(mill, steps, {}, 1), trial_deck(mill, {25, 100}, "x", 3),
                           measuring_deck(mill, steps, mill.liner, "x", 3)})
    EXPECT_THAT(deck, HasSubstr("\nprocessors    1 * 1\n"));
}

TEST(Deck, HasSlabsAlongTheAxisWhereTheCaseWantsThem) {
  Case mill = example_case();
  mill.dem.rank_split = RankSplit::axis;
  EXPECT_THAT(measuring_deck(mill, steps, mill.liner, "x", 2),
              HasSubstr("\nprocessors    1 * 1\n"));
  mill.dem.rank_split = RankSplit::charge;
  EXPECT_EQ(rank_split(mill, 2), RankSplit::charge);
  EXPECT_EQ(rank_split(mill, 3), RankSplit::axis);
}

TEST(Deck, GivesEveryMeshAnIdOfItsOwn) {
  EXPECT_THAT(liner_deck(StretchKind::mix, 0), HasSubstr("fix liner_000_mix all mesh/surface"));
  EXPECT_THAT(liner_deck(StretchKind::measure, 0), HasSubstr("fix liner_000 all mesh/surface"));
  EXPECT_THAT(liner_deck(StretchKind::measure, 12), HasSubstr("fix liner_012 all mesh/surface"));
  EXPECT_THAT(liner_deck(StretchKind::mix, 0, 2),
              HasSubstr("fix liner_000_mix_chunk_2 all mesh/surface"));
}

TEST(Deck, OfALaterChunkOfAMixingReadsTheOneBefore) {
  const Case mill = example_case();
  const auto deck = mixing_deck(mill, steps, "../.mix.chunk_0/charge.restart", 1);
  EXPECT_THAT(deck, HasSubstr("\nread_restart  ../.mix.chunk_0/charge.restart\n"));
  EXPECT_THAT(deck, Not(HasSubstr("read_data")));
}

// 1 m wide and 0.2 m long: eight ranks have the least surface as eight columns, and as two by four
// where the slice is 3 m.
TEST(Deck, HasBalancedColumnsForAnyNumberOfRanks) {
  Case mill = example_case();
  mill.dem.rank_split = RankSplit::balanced;
  EXPECT_THAT(measuring_deck(mill, steps, mill.liner, "x", 3),
              HasSubstr("\nprocessors    3 1 1\n"));
  EXPECT_THAT(measuring_deck(mill, steps, mill.liner, "x", 8),
              HasSubstr("\nprocessors    8 1 1\n"));
  EXPECT_EQ(columns_to_balance(mill, 8), 8);
  EXPECT_EQ(columns_to_balance(mill, 1), std::nullopt);
  mill.slice_length = 3.0;
  EXPECT_THAT(measuring_deck(mill, steps, mill.liner, "x", 8),
              HasSubstr("\nprocessors    2 4 1\n"));
  mill.dem.rank_split = RankSplit::charge;
  EXPECT_EQ(columns_to_balance(mill, 8), std::nullopt);
}

// The charge falls for a quarter of a revolution before its columns are cut for the rest.
TEST(Deck, OfAMixingInBalancedColumnsHasTwoRuns) {
  Case mill = example_case();
  mill.dem.rank_split = RankSplit::balanced;
  const long falling = 3 * plan_steps(mill).steps_per_pitch;
  const StretchSteps mixing{4e-5, 5 * falling, 0, 20};
  EXPECT_THAT(
      mixing_deck(mill, mixing, {}, 2),
      HasSubstr(fmt::format("\nrun           {}\nrun           {}\n", falling, 4 * falling)));
}

TEST(Deck, OfAMixingThatEndsOnceItIsSteadyAveragesOverItsPieces) {
  Case mill = example_case();
  EXPECT_THAT(mixing_deck(mill, steps, {}, 1), Not(HasSubstr("drift")));
  mill.dem.mix_until_steady = true;
  const long piece = mixing_plan(mill, plan_steps(mill)).piece;
  EXPECT_THAT(
      mixing_deck(mill, steps, {}, 1),
      HasSubstr(fmt::format("fix           drift all ave/time 1 {0} {0} v_torque c_kinetic\n"
                            "run           24000\n",
                            piece)));
}

// G = 7.752e10 / 100, nu = 0.29: E = 2 G (1 + nu) = 2.000016e9 Pa.
TEST(Deck, GivesLiggghtsTheSoftenedModuliAndEveryPair) {
  const auto deck = liner_deck(StretchKind::measure, 0);
  EXPECT_THAT(deck, HasSubstr("youngsModulus peratomtype 2000016000"));
  EXPECT_THAT(deck, HasSubstr("coefficientFriction peratomtypepair 2 0.3 0.5 0.5 0.8\n"));
  EXPECT_THAT(deck, HasSubstr("coefficientRestitution peratomtypepair 2 0.3 0.5 0.5 0.5\n"));
  EXPECT_THAT(deck, HasSubstr("coefficientRollingFriction peratomtypepair 2 0.001 0.002 0.002 "));
  EXPECT_THAT(deck, HasSubstr("timestep      4e-05\n"));
  EXPECT_THAT(deck, HasSubstr("period 2.0943951"));
}

// The lifters' flat tops reach in to 0.46 m (their edges only to 0.4607 m) and the largest ball has
// a radius of 25 mm. 2 % of its diameter may overlap, and the mesh may stand out by 3 % of 10 mm:
// a ball whose centre is nearer to the axis than 0.46 - 0.025 - 0.001 - 0.0003 m cannot touch.
TEST(Deck, DumpsTheSpinOfEveryParticleThatCanTouch) {
  const Case mill = example_case();
  const auto deck = measuring_deck(mill, steps, mill.liner, "x", 1);
  const std::string before = "region        near_wall cylinder y 0 0 ";
  const auto start = deck.find(before);
  ASSERT_NE(start, std::string::npos);
  EXPECT_NEAR(std::stod(deck.substr(start + before.size())), 0.4337, 1e-9);
}

TEST(Deck, SkinIsTheLeastRadiusUnlessGiven) {
  Case mill = example_case();
  EXPECT_EQ(neighbour_skin(mill), 0.01);
  mill.dem.skin = 0.02;
  EXPECT_EQ(neighbour_skin(mill), 0.02);
}

}  // namespace
}  // namespace millwear::liggghts
