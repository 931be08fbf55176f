#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "liggghts_inputs/decks/deck.h"
#include "mill/case/time_step.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;

class RecordedMill : public ::testing::Test {
 protected:
  explicit RecordedMill(const Case& mill = small_mill(ContactPath::recorder)) : mill_(mill) {}

  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
    mix(mill_, {plan_.time_step, 2 * plan_.steps_per_pitch, 0, 20}, scratch_.stage("mix"), 1);
  }

  void expect_same_bits(const StretchSteps& steps);

  Case mill_;
  const StepPlan plan_ = plan_steps(mill_);
  const ScratchFolder scratch_;
};

double sum(const WallLoad& load, Measure measure) { return load.total(measure).sum(); }

/// Has the deck in a folder print every particle at its end, to the last bit.
void add_final_dump(const std::filesystem::path& folder) {
  const auto deck = folder / liggghts::file_names::deck;
  std::string text = text_of(deck);
  text.insert(
      text.find("write_restart"),
      "dump last all custom 1 last.dump id x y z vx vy vz omegax omegay omegaz\n"
      "dump_modify last sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g "
      "%.17g\"\nrun 0\n");
  write_text(deck, text);
}

void RecordedMill::expect_same_bits(const StretchSteps& steps) {
  const auto plain = scratch_.stage(fmt::format("plain{}", steps.pair_steps));
  const auto recorded = scratch_.stage(fmt::format("recorded{}", steps.pair_steps));
  measure(mill_, steps, mill_.liner, plain, "mix", 0, 2, add_final_dump);
  record(mill_, steps, mill_.liner, recorded, "mix", 2, add_final_dump);
  EXPECT_GT(text_of(plain / "last.dump").size(), 10000u);
  EXPECT_TRUE(text_of(plain / "last.dump") == text_of(recorded / "last.dump")) << steps.pair_steps;
}

// The recorder changes nothing: with it and without, two ranks end in the same particles to the
// last bit, also where it keeps the forces between particles.
TEST_F(RecordedMill, EndsInTheSameBitsAsWithoutTheRecorder) {
  for (const long pair_steps : {0L, 1000L})
    expect_same_bits({plan_.time_step, 500, 2500, 1, pair_steps});
}

/// Places and velocities of the last dump, by the particles' numbers.
std::vector<double> last_state(const std::filesystem::path& folder) {
  std::istringstream text(text_of(folder / "last.dump"));
  std::string line;
  while (std::getline(text, line) && !line.starts_with("ITEM: ATOMS")) continue;
  std::vector<double> values;
  for (double value; text >> value;) values.push_back(value);
  return values;
}

// Columns that are cut anew before every run, with other ranks for most particles and their
// contacts: the same trajectories to rounding, and the same load.
TEST_F(RecordedMill, IsTheSameInBalancedColumns) {
  const StretchSteps steps{plan_.time_step, 100, 200, 1, 100};
  const auto alone = scratch_.stage("alone");
  const auto load = record(mill_, steps, mill_.liner, alone, "mix", 1, add_final_dump).record.load;
  mill_.dem.rank_split = RankSplit::balanced;
  for (const int ranks : {2, 3, 4}) {
    const auto folder = scratch_.stage(fmt::format("balanced{}", ranks));
    const auto shared =
        record(mill_, steps, mill_.liner, folder, "mix", ranks, add_final_dump).record.load;
    const auto mine = last_state(folder);
    const auto theirs = last_state(alone);
    ASSERT_EQ(mine.size(), theirs.size());
    ASSERT_GT(mine.size(), 1000U);
    for (std::size_t i = 0; i < mine.size(); ++i)
      EXPECT_NEAR(mine[i], theirs[i], 1e-6 * std::max(1.0, std::abs(theirs[i]))) << i;
    for (const Measure measure : {Measure::samples, Measure::events, Measure::sliding_work})
      EXPECT_NEAR(sum(shared, measure), sum(load, measure), 1e-6 * sum(load, measure)) << ranks;
  }
}

/// The small mill with particles of 6 mm between its balls of 30: its neighbours lie in grids of
/// three octaves.
class RecordedMillOfManySizes : public RecordedMill {
 protected:
  static Case mill() {
    Case mill = small_mill(ContactPath::recorder);
    mill.charge.classes.push_back({0, 0.012, 100});
    mill.charge.classes.push_back({0, 0.006, 600});
    return mill;
  }
  RecordedMillOfManySizes() : RecordedMill(mill()) {}
};

TEST_F(RecordedMillOfManySizes, EndsInTheSameBitsAsWithoutTheRecorder) {
  expect_same_bits({plan_.time_step, 500, 2500, 1});
}

/// Rolling friction that keeps its own values in a contact's history, behind those of sliding.
class RecordedMillWithRollingSprings : public RecordedMill {
 protected:
  static Case mill() {
    Case mill = small_mill(ContactPath::recorder);
    mill.dem.rolling_friction = RollingFriction::epsd2;
    return mill;
  }
  RecordedMillWithRollingSprings() : RecordedMill(mill()) {}
};

TEST_F(RecordedMillWithRollingSprings, EndsInTheSameBitsAsWithoutTheRecorder) {
  expect_same_bits({plan_.time_step, 500, 2500, 1});
}

/// With an option for its models, even the one that is on anyway, LIGGGHTS loops over its pairs
/// itself.
void leave_pairs_to_liggghts(const std::filesystem::path& folder) {
  const auto file = folder / liggghts::file_names::contact_model;
  std::string text = text_of(file);
  text.insert(text.find('\n', text.find("pair_style")), " tangential_damping on");
  write_text(file, text);
}

TEST_F(RecordedMill, KeepsTheForcesBetweenParticlesThatLiggghtsKeeps) {
  const StretchSteps steps{plan_.time_step, 500, 2500, 1, 2000};
  const auto pairs = [&](const char* stage, const ChangeDeck& change) {
    return *record(mill_, steps, mill_.liner, scratch_.stage(stage), "mix", 2, change).record.pairs;
  };
  const auto ours = pairs("ours", {});
  const auto theirs = pairs("theirs", leave_pairs_to_liggghts);
  EXPECT_GT(ours.spectrum.normal_events.sum(), 100.0);
  EXPECT_EQ(ours.spectrum.normal_events, theirs.spectrum.normal_events);
  EXPECT_EQ(ours.spectrum.shear_energy, theirs.spectrum.shear_energy);
  EXPECT_EQ(ours.rolling_dissipation, theirs.rolling_dissipation);
}

// The dumps and the recorder on the same run, both every 20 steps and without damping, which the
// dumps evaluate with other velocities: the same contacts in the same cells with the same forces,
// to the digits that the dumps have. Neither settling nor the measurement is a multiple of 20
// steps: the first samples are 20 steps from the beginning, the last ones stand for 5.
TEST_F(RecordedMill, SeesWhatTheDumpsSee) {
  mill_.dem.contact_path = ContactPath::dumps;
  mill_.pairs.front().restitution = 1.0;
  const StretchSteps steps{plan_.time_step, 507, 4005, 20};
  const Recording recording = record(mill_, steps, mill_.liner, scratch_.stage("both"), "mix", 2);
  const WallLoad dumped = load_of(mill_, steps, mill_.liner, recording.dumps);
  const WallLoad recorded = wear::coarsened(recording.record.load, wear::cells_per_bin);
  EXPECT_GT(sum(recorded, Measure::samples), 1000.0);
  EXPECT_EQ(sum(recorded, Measure::samples), sum(dumped, Measure::samples));
  EXPECT_EQ(sum(recorded, Measure::events), sum(dumped, Measure::events));
  for (const Measure measure : {Measure::samples, Measure::events, Measure::normal_impulse,
                                Measure::sliding_work, Measure::normal_dissipation}) {
    const auto& mine = recorded.values[index_of(measure)];
    const auto& theirs = dumped.values[index_of(measure)];
    EXPECT_LT((mine - theirs).cwiseAbs().sum(), 2e-3 * mine.cwiseAbs().sum())
        << measure_names[index_of(measure)];
  }
}

// A collision lasts some twenty steps, so every second step finds as many of them as every step.
TEST_F(RecordedMill, FindsAsManyCollisionsAtHalfTheResolutionInTime) {
  const auto collisions = [&](long every) {
    const StretchSteps steps{plan_.time_step, 500, 2 * plan_.steps_per_pitch, every};
    const auto folder = scratch_.stage(fmt::format("every{}", every));
    return sum(record(mill_, steps, mill_.liner, folder, "mix", 1).record.load, Measure::events);
  };
  const double all = collisions(1);
  const double half = collisions(2);
  RecordProperty("collisions", fmt::format("{} {}", all, half));
  EXPECT_GT(all, 500.0);
  EXPECT_NEAR(half, all, 0.02 * all);
}

}  // namespace
}  // namespace millwear::trial
