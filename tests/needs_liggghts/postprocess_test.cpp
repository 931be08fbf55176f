#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/needs_liggghts/trial_run.h"

namespace millwear::trial {
namespace {

namespace fs = std::filesystem;

const std::string millwear = MILLWEAR_PROGRAM;
const std::string dump_mill = MILLWEAR_TRIAL_CASES "/dump_mill.toml";

class Postprocess : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }

  [[nodiscard]] int run(const std::string& command) const {
    return std::system(fmt::format("cd {} && {} > {}.log 2>&1", folder_.string(), command,
                                   (folder_ / "last").string())
                           .c_str());
  }

  void run_by_hand(const std::string& stretch) const {
    ASSERT_EQ(run(fmt::format("cd {} && mpirun --allow-run-as-root -np 1 --bind-to none liggghts "
                              "-in deck.in -log none",
                              stretch)),
              0)
        << text_of(folder_ / "last.log");
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.stage("trial");
};

void replace(std::string& text, const std::string& before, const std::string& after) {
  const auto at = text.find(before);
  ASSERT_NE(at, std::string::npos) << before;
  text.replace(at, before.size(), after);
}

/// Has the deck dump the contacts in another order, with the mesh's number and a name of its own.
void dump_in_another_order(const fs::path& deck) {
  std::string text = text_of(deck);
  for (std::size_t at = 0; (at = text.find("c_hits[", at)) != std::string::npos;)
    text.replace(at, 7, "c_touch[");
  replace(text, "compute       hits", "compute       touch");
  replace(text, "c_touch[1] c_touch[2] c_touch[3] c_touch[8] c_touch[9]",
          "c_touch[9] c_touch[7] c_touch[8] c_touch[3] c_touch[1] c_touch[2]");
  replace(text, "format \"%.9g", "format \"%.9g %.9g");
  write_text(deck, text);
}

// The program's own campaign through dumps, and the same decks run by hand with columns in another
// order: the same load and the same steps of wear, to the last bit. Settling takes 1105 steps and
// the measurement 2210, with a sample every 20, so that neither is a multiple of it.
TEST_F(Postprocess, OfAHandRunDeckGivesTheLoadOfTheCampaign) {
  ASSERT_EQ(run(fmt::format("{} run {} --out run --quiet", millwear, dump_mill)), 0)
      << text_of(folder_ / "last.log");
  ASSERT_EQ(run(fmt::format("{} deck {} --out deck", millwear, dump_mill)), 0);
  const fs::path dem = folder_ / "deck/cycle_000/dem";
  dump_in_another_order(dem / "deck.in");
  run_by_hand("deck/cycle_000/mix");
  run_by_hand("deck/cycle_000/dem");
  const std::string model = text_of(dem / "contact_model.in");
  const auto step = model.find("\ntimestep") + 9;
  ASSERT_EQ(run(fmt::format("{} postprocess {} --contacts {}/contacts.dump --particles "
                            "{}/spins.dump --timestep {} --mesh deck/cycle_000/mesh/liner.stl "
                            "--out worn",
                            millwear, dump_mill, dem.string(), dem.string(),
                            model.substr(step, model.find('\n', step) - step))),
            0)
      << text_of(folder_ / "last.log");
  const std::string load = text_of(folder_ / "worn/load.h5");
  EXPECT_GT(load.size(), 1000u);
  EXPECT_TRUE(load == text_of(folder_ / "run/cycle_000/dem/load.h5"));
  EXPECT_EQ(text_of(folder_ / "worn/steps.json"),
            text_of(folder_ / "run/cycle_000/wear/steps.json"));
  for (const char* const file : {"profile.csv", "liner.stl", "profile.step", "profile.dxf"})
    EXPECT_TRUE(fs::exists(folder_ / "worn" / file)) << file;
}

}  // namespace
}  // namespace millwear::trial
