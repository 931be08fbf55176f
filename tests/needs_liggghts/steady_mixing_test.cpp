#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "liggghts_inputs/decks/charge_packing.h"
#include "liggghts_inputs/decks/deck.h"
#include "mill/case/time_step.h"
#include "mill/load/mixing_record.h"
#include "orchestrator/dem_run/mixing.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

namespace names = liggghts::file_names;
using liggghts::StretchSteps;

constexpr double one_piece = 1.0 / 6.0;  // of the small mill, a pitch

class SteadyMixing : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
    mill_.dem.mix_until_steady = true;
  }

  /// Writes the deck of the mill and runs it with the recorder; returns what it left.
  [[nodiscard]] std::string mix_until_steady(const std::string& stage, int ranks = 1,
                                             const ChangeDeck& change = {}) const {
    const auto folder = scratch_.stage(stage);
    const auto steps = liggghts::mixing_steps(mill_, plan_);
    const auto mesh = write_liner_mesh(mill_, mill_.liner, folder);
    write_text(folder / names::charge,
               liggghts::charge_data_file(mill_, liggghts::pack_charge(mill_)));
    write_text(folder / names::deck, liggghts::mixing_deck(mill_, steps, {}, ranks));
    write_text(folder / names::contact_model,
               liggghts::contact_model_deck(mill_, steps, {"liner.stl", mesh.triangles.size()},
                                            {liggghts::StretchKind::mix, 0}));
    if (change) change(folder);
    orchestrator::run_liggghts(
        {folder,
         ranks,
         {},
         orchestrator::RecorderProgram{MILLWEAR_RECORDER,
                                       orchestrator::mixing_arguments(mill_, ranks)}},
        {});
    return text_of(folder / "mixing.csv");
  }

  [[nodiscard]] MixingRecord record_of(const std::string& stage) const {
    return orchestrator::read_mixing(mill_, scratch_.stage(stage));
  }

  [[nodiscard]] std::string file_of(const std::string& stage, const char* name) const {
    return text_of(scratch_.stage(stage) / name);
  }

  Case mill_ = small_mill(ContactPath::recorder);
  const StepPlan plan_ = plan_steps(mill_);
  const ScratchFolder scratch_;
};

// It ends before the most, after whole pitches, the same each time; and the charge it leaves is
// that of a plain liggghts whose deck was that long from the start, to the last bit.
TEST_F(SteadyMixing, EndsEarlyAsAPlainDeckOfThatLengthDoes) {
  mill_.dem.mix_revolutions = 5.0;
  const std::string left = mix_until_steady("steady");
  const auto record = record_of("steady");
  EXPECT_EQ(mixing_state(record.plan, record.pieces), MixingState::steady);
  EXPECT_LT(record.steps(), record.plan.most);
  EXPECT_GE(record.steps(), least_steps(record.plan));
  EXPECT_EQ(record.steps() % plan_.steps_per_pitch, 0);
  const std::string log = file_of("steady", names::log);
  EXPECT_NE(log.find(fmt::format("millwear: step {}, torque drifts by ", record.steps())),
            std::string::npos)
      << log;

  EXPECT_EQ(mix_until_steady("again"), left);
  EXPECT_TRUE(file_of("again", names::restart) == file_of("steady", names::restart));

  Case plain = mill_;
  plain.dem.mix_until_steady = false;
  mix(plain, StretchSteps{plan_.time_step, record.steps(), 0, 20}, scratch_.stage("plain"), 1);
  EXPECT_TRUE(file_of("plain", names::restart) == file_of("steady", names::restart));
}

// The means are those of the torque that the deck prints, which is the mesh's, and of the energy.
TEST_F(SteadyMixing, AveragesWhatTheDeckPrints) {
  mill_.dem.mix_revolutions = one_piece;
  static_cast<void>(mix_until_steady("every_step", 1, [](const std::filesystem::path& folder) {
    std::string deck = text_of(folder / names::deck);
    const auto place = deck.find("thermo        ");
    deck.replace(place, deck.find('\n', place) - place, "thermo        1");
    write_text(folder / names::deck, deck);
  }));
  const auto record = record_of("every_step");
  ASSERT_EQ(record.pieces.size(), 1U);
  double torque = 0.0;
  double energy = 0.0;
  for (const auto& line : log_of(scratch_.stage("every_step")).thermo) {
    if (line.step == 0) continue;
    torque += line.torque / static_cast<double>(record.plan.piece);
    energy += line.kinetic_energy / static_cast<double>(record.plan.piece);
  }
  EXPECT_NEAR(record.pieces.front().torque, torque, 1e-6 * std::abs(torque));
  EXPECT_NEAR(record.pieces.front().kinetic_energy, energy, 1e-6 * energy);
}

// Ten pitches are the fewest that can be steady; of nine it goes through all and says so.
TEST_F(SteadyMixing, GoesNoFurtherThanTheMost) {
  mill_.dem.mix_revolutions = 1.5;
  static_cast<void>(mix_until_steady("most"));
  const auto record = record_of("most");
  EXPECT_EQ(record.steps(), 9 * plan_.steps_per_pitch);
  EXPECT_EQ(mixing_state(record.plan, record.pieces), MixingState::at_most);
  EXPECT_EQ(log_of(scratch_.stage("most")).thermo.back().step, record.steps());
  EXPECT_TRUE(log_of(scratch_.stage("most")).complete);
}

// Each rank holds a part of the charge; torque and energy are of all.
TEST_F(SteadyMixing, DecidesOnWhatAllRanksHold) {
  mill_.dem.mix_revolutions = one_piece;
  static_cast<void>(mix_until_steady("one"));
  static_cast<void>(mix_until_steady("two", 2));
  const auto one = record_of("one").pieces.front();
  const auto two = record_of("two").pieces.front();
  EXPECT_NEAR(one.torque, two.torque, 0.2 * std::abs(one.torque));
  EXPECT_NEAR(one.kinetic_energy, two.kinetic_energy, 0.2 * one.kinetic_energy);
}

// A deck whose averages or run are other than the recorder was told is refused, and leaves nothing.
TEST_F(SteadyMixing, RefusesADeckOfAnotherPlan) {
  mill_.dem.mix_revolutions = one_piece;
  const auto without = [this](const std::string& stage, const std::string& words,
                              const std::string& instead) {
    return mix_until_steady(stage, 1, [&](const std::filesystem::path& folder) {
      std::string deck = text_of(folder / names::deck);
      deck.replace(deck.find(words), words.size(), instead);
      write_text(folder / names::deck, deck);
    });
  };
  EXPECT_EQ(without("no_average", "fix           drift", "fix           other"), "");
  EXPECT_NE(file_of("no_average", names::log).find("ERROR: deck.in: no `fix drift all ave/time"),
            std::string::npos);
  EXPECT_EQ(without("other_run", "\nrun           ", "\nrun           1"), "");
  EXPECT_NE(file_of("other_run", names::log).find("of a mixing deck is of --at-most"),
            std::string::npos);
}

}  // namespace
}  // namespace millwear::trial
