#include "liggghts_inputs/decks/chunks.h"

#include <gmock/gmock.h>

#include "tests/support/example_case.h"

namespace millwear::liggghts {
namespace {

Case recorded_case(double chunk_particle_steps) {
  Case mill = example_case();
  mill.dem.contact_path = ContactPath::recorder;
  mill.dem.chunk_particle_steps = chunk_particle_steps;
  mill.dem.measure_revolutions = 7.0 / 12.0;
  mill.dem.pair_revolutions = 0.02;
  return mill;
}

std::vector<Chunk> measuring_chunks(const Case& mill) {
  return chunks_of(mill, measuring_steps(mill, plan_steps(mill)), plan_steps(mill));
}

std::vector<Chunk> mixing_chunks(const Case& mill) {
  return chunks_of(mill, mixing_steps(mill, plan_steps(mill)), plan_steps(mill));
}

/// Particle steps of a pitch.
double of_a_pitch(const Case& mill) {
  return static_cast<double>(totals(mill).particles) *
         static_cast<double>(plan_steps(mill).steps_per_pitch);
}

TEST(Chunks, AreTheStretchWhereItIsShort) {
  const Case mill = recorded_case(1e15);
  const auto stretch = measuring_steps(mill, plan_steps(mill));
  const auto chunks = measuring_chunks(mill);
  ASSERT_EQ(chunks.size(), 1U);
  EXPECT_EQ(chunks[0].steps.total(), stretch.total());
  EXPECT_EQ(chunks[0].steps.pair_steps, stretch.pair_steps);
}

// Nine pitches with two of settling, three in a chunk: three chunks of 2, 2 and 3 measured pitches.
TEST(Chunks, OfAMeasurementAreWholePitchesThatFollowEachOther) {
  Case mill = recorded_case(1.0);
  mill.dem.chunk_particle_steps = 3.0 * of_a_pitch(mill);
  const auto plan = plan_steps(mill);
  const auto stretch = measuring_steps(mill, plan);
  const auto chunks = measuring_chunks(mill);
  ASSERT_EQ(chunks.size(), 3U);
  long measured = 0;
  for (const Chunk& chunk : chunks) {
    EXPECT_EQ(chunk.measured_before, measured);
    EXPECT_EQ(chunk.steps.measure_steps % plan.steps_per_pitch, 0);
    EXPECT_EQ(chunk.steps.settle_steps, (chunk.number == 0 ? 2 : 1) * plan.steps_per_pitch);
    EXPECT_EQ(chunk.steps.torque_interval(), stretch.torque_interval());
    EXPECT_EQ(chunk.steps.pair_steps, chunk.number == 2 ? stretch.pair_steps : 0);
    measured += chunk.steps.measure_steps;
  }
  EXPECT_EQ(measured, stretch.measure_steps);
}

TEST(Chunks, OfAMixingMakeItsSteps) {
  Case mill = recorded_case(1.0);
  mill.dem.chunk_particle_steps = 5.0 * of_a_pitch(mill);
  const auto chunks = mixing_chunks(mill);  // two revolutions are 24 pitches
  ASSERT_EQ(chunks.size(), 5U);
  long steps = 0;
  for (const Chunk& chunk : chunks) steps += chunk.steps.total();
  EXPECT_EQ(steps, 24 * plan_steps(mill).steps_per_pitch);
}

TEST(Chunks, AreAPitchAtLeast) {
  const auto chunks = measuring_chunks(recorded_case(1.0));
  EXPECT_EQ(chunks.size(), 7U);
}

TEST(Chunks, AreNotMadeOfDumpsNorOfAMixingUntilItIsSteady) {
  Case mill = recorded_case(1.0);
  mill.dem.mix_until_steady = true;
  EXPECT_EQ(mixing_chunks(mill).size(), 1U);
  mill.dem.contact_path = ContactPath::dumps;
  EXPECT_EQ(measuring_chunks(mill).size(), 1U);
}

TEST(Chunks, GoOnByWholeBlocks) {
  Case mill = recorded_case(1.0);
  mill.dem.error_target = ErrorTarget{0.05, 4.0};
  const auto plan = plan_steps(mill);
  const auto stretch = measuring_steps(mill, plan);
  const Chunk last = measuring_chunks(mill).back();
  const Chunk next = chunk_after(last, stretch, plan);
  EXPECT_EQ(next.number, 7);
  EXPECT_EQ(next.measured_before, stretch.measure_steps);
  EXPECT_EQ(next.steps.measure_steps, stretch.go_on_steps);
  EXPECT_EQ(next.steps.settle_steps, plan.steps_per_pitch);
  EXPECT_EQ(next.steps.pair_steps, 0);
}

}  // namespace
}  // namespace millwear::liggghts
