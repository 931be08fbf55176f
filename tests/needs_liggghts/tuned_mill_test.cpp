#include <fmt/format.h>
#include <gmock/gmock.h>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "orchestrator/dem_run/tuning_file.h"
#include "orchestrator/stages/run_stage.h"
#include "orchestrator/stretch/stretch_stages.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

using namespace orchestrator;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Case tuned_mill() {
  Case mill = small_mill(ContactPath::dumps);
  mill.dem.mix_revolutions = 0.2;
  mill.dem.measure_revolutions = 0.2;
  mill.dem.tune = true;
  return mill;
}

class TunedMill : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }

  /// Runs one cycle and tells the stages in their order.
  std::vector<std::string> run_a_cycle() {
    Progress progress(Verbosity::quiet);
    std::vector<std::string> stages;
    const CampaignEffects effects{
        [&](const StageId& stage) { return run_stage(campaign, stage, progress); },
        [&](const LedgerEntry& entry) { stages.push_back(name_of(entry.stage)); },
        [](const Ledger&) {}};
    CampaignPlan plan = plan_of(campaign.mill);
    plan.cycle_limit = 1;
    run_campaign({{"millwear", "hash", 1, "host"}, {}}, plan, effects);
    return stages;
  }

  [[nodiscard]] std::string text_in(StageKind kind, const char* file) const {
    return read_file(campaign.folder.stage({0, kind}) / file);
  }

  [[nodiscard]] Tuning kept_tuning() const {
    return read_tuning(campaign.folder.stage({0, StageKind::tune}) / stage_files::tuning);
  }

  ScratchFolder scratch;
  Campaign campaign{tuned_mill(), {scratch.stage("run")}, 1};
};

// LIGGGHTS takes every skin of the ladder, tells its loop time and its builds, and rebuilds the
// less often the wider the skin. The load is measured with the skin that was chosen.
TEST_F(TunedMill, MeasuresWithTheSkinItChose) {
  EXPECT_THAT(run_a_cycle(), ElementsAre("cycle 0 mesh", "cycle 0 mix", "cycle 0 tune",
                                         "cycle 0 dem", "cycle 0 wear"));
  const Tuning tuning = kept_tuning();
  EXPECT_EQ(tuning.particles, 120u);
  EXPECT_THAT(tuning.split_trials, IsEmpty());
  ASSERT_EQ(tuning.skin_trials.size(), skins_on_trial(campaign.mill).size());
  for (std::size_t i = 0; i < tuning.skin_trials.size(); ++i) {
    const auto& trial = tuning.skin_trials[i];
    EXPECT_EQ(trial.refused, "") << trial.settings.skin;
    EXPECT_EQ(trial.loop_seconds.size(), 3u);
    EXPECT_GT(median_seconds(trial), 0.0);
    EXPECT_EQ(trial.dangerous_builds, 0);
    EXPECT_GE(trial.neighbour_builds, 4);
    if (i == 0) continue;
    EXPECT_LT(trial.neighbour_builds, tuning.skin_trials[i - 1].neighbour_builds)
        << trial.settings.skin;
  }
  EXPECT_THAT(text_in(StageKind::dem, liggghts::file_names::deck),
              HasSubstr(fmt::format("neighbor      {} bin\n", tuning.chosen.skin)));
  EXPECT_THAT(
      text_in(StageKind::mix, liggghts::file_names::deck),
      HasSubstr(fmt::format("neighbor      {} bin\n", liggghts::neighbour_skin(campaign.mill))));
}

// Two ranks: both splits from the same restart file, and the load measured with the faster.
TEST_F(TunedMill, SharesTheMillAmongRanksAsItChose) {
  campaign.ranks = 2;
  run_a_cycle();
  const Tuning tuning = kept_tuning();
  ASSERT_EQ(tuning.split_trials.size(), 2u);
  for (const auto& trial : tuning.split_trials) {
    EXPECT_EQ(trial.refused, "") << name_of(trial.settings.rank_split);
    EXPECT_EQ(trial.loop_seconds.size(), 3u);
  }
  const RankSplit faster = fastest_settings(tuning.split_trials)->rank_split;
  for (const auto& trial : tuning.skin_trials) EXPECT_EQ(trial.settings.rank_split, faster);
  const char* const grid = faster == RankSplit::charge ? "2 * 1" : "1 * 1";
  EXPECT_THAT(text_in(StageKind::dem, liggghts::file_names::deck),
              HasSubstr(fmt::format("processors    {}\n", grid)));
  EXPECT_THAT(text_in(StageKind::mix, liggghts::file_names::deck),
              HasSubstr("processors    2 * 1\n"));
}

// A step of half a skin and more may pass a contact by: LIGGGHTS counts such builds, and the skin
// is refused.
TEST_F(TunedMill, TakesNoSkinThatIsCrossedInOneStep) {
  Progress progress(Verbosity::quiet);
  campaign.mill.dem.tune = false;
  campaign.mill.dem.skin = 1e-6;
  for (const StageKind kind : {StageKind::mesh, StageKind::mix, StageKind::tune})
    static_cast<void>(run_stage(campaign, {0, kind}, progress));
  const Tuning tuning = kept_tuning();
  const DeckTrial& thinnest = tuning.skin_trials.front();
  EXPECT_EQ(thinnest.settings.skin, 1e-6);
  EXPECT_GT(thinnest.dangerous_builds, 0);
  EXPECT_THAT(thinnest.refused, HasSubstr("in one step"));
  EXPECT_EQ(thinnest.loop_seconds.size(), 1u);
  EXPECT_GT(tuning.chosen.skin, 1e-6);
}

}  // namespace
}  // namespace millwear::trial
