#include "orchestrator/dem_run/tuning.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/dem_run/tune_stage.h"
#include "orchestrator/dem_run/tuning_file.h"
#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

DeckTrial trial_of(double skin, std::vector<double> seconds, RankSplit split = RankSplit::charge) {
  return {.settings = {split, skin}, .loop_seconds = std::move(seconds), .neighbour_builds = 10};
}

TEST(SplitsOnTrial, AreBothForAnEvenNumberOfRanksTheCasesFirst) {
  Case mill = example_case();
  EXPECT_THAT(splits_on_trial(mill, 2), ElementsAre(RankSplit::charge, RankSplit::axis));
  mill.dem.rank_split = RankSplit::axis;
  EXPECT_THAT(splits_on_trial(mill, 4), ElementsAre(RankSplit::axis, RankSplit::charge));
}

TEST(SplitsOnTrial, AreNoneForAnOddNumber) {
  for (const int ranks : {1, 3}) EXPECT_THAT(splits_on_trial(example_case(), ranks), IsEmpty());
}

// The least radius is 10 mm; 0.15 to 2 radii in seven equal ratios.
TEST(SkinsOnTrial, AreALadderAroundTheLeastRadiusAndTheCasesOwn) {
  const Case mill = example_case();
  EXPECT_THAT(skins_on_trial(mill),
              ElementsAre(0.0015, 0.00231, 0.00356, 0.00548, 0.00843, 0.01, 0.013, 0.02));
}

TEST(SkinsOnTrial, HoldTheCasesOwnOnce) {
  Case mill = example_case();
  mill.dem.skin = 0.0132;
  EXPECT_THAT(skins_on_trial(mill),
              ElementsAre(0.0015, 0.00231, 0.00356, 0.00548, 0.00843, 0.0132, 0.02));
}

// The liner moves 1.5 m/s: half a skin of 20 mm in 1/150 s, four times in a piece.
TEST(TrialSteps, LetTheWidestSkinBeRebuilt) {
  const Case mill = example_case();
  const double four_builds = 4.0 / 150.0 / plan_steps(mill).time_step;
  const auto steps = trial_steps(mill, {0.002, 0.02});
  EXPECT_NEAR(static_cast<double>(steps.timed), four_builds, 1.0);
  EXPECT_EQ(steps.warm_up, steps.timed / 4);
}

TEST(TrialSteps, AreNeverTooFewToTime) {
  EXPECT_EQ(trial_steps(example_case(), {1e-6}).timed, 100);
}

TEST(MedianSeconds, AreThoseOfTheMiddlePiece) {
  EXPECT_EQ(median_seconds(trial_of(0.01, {9.0, 1.0, 2.0})), 2.0);
  EXPECT_EQ(median_seconds(trial_of(0.01, {4.0, 1.0, 2.0, 9.0})), 3.0);
}

// One piece that something else on the machine slowed down does not decide.
TEST(FastestSettings, AreTheFastestByTheMedian) {
  EXPECT_EQ(fastest_settings({trial_of(0.01, {1.2, 1.2, 1.2}), trial_of(0.02, {9.0, 1.0, 1.0}),
                              trial_of(0.03, {0.5, 1.5, 1.5})})
                ->skin,
            0.02);
  EXPECT_EQ(fastest_settings(
                {trial_of(0.01, {1.2}, RankSplit::charge), trial_of(0.01, {1.1}, RankSplit::axis)})
                ->rank_split,
            RankSplit::axis);
}

TEST(FastestSettings, AreTheFirstOfThoseEquallyFast) {
  EXPECT_EQ(
      fastest_settings({trial_of(0.01, {1.03}), trial_of(0.02, {1.015}), trial_of(0.03, {1.0})})
          ->skin,
      0.02);
  EXPECT_EQ(fastest_settings({trial_of(0.01, {1.015}, RankSplit::charge),
                              trial_of(0.01, {1.0}, RankSplit::axis)})
                ->rank_split,
            RankSplit::charge);
}

TEST(ChosenSettings, HaveNoSkinWithDangerousBuilds) {
  std::vector<DeckTrial> trials = {{.settings = {RankSplit::axis, 0.01}},
                                   {.settings = {RankSplit::axis, 0.02}}};
  for (const long dangerous : {0L, 1L, 0L}) add_piece(trials[0], 1.0, 30, dangerous);
  for (int piece = 0; piece < 3; ++piece) add_piece(trials[1], 2.0, 20, 0);
  EXPECT_EQ(trials[0].dangerous_builds, 1);
  EXPECT_NE(trials[0].refused, "");
  EXPECT_EQ(chosen_settings(trials), trials[1].settings);
}

TEST(ChosenSettings, SayWhyWhereThereAreNone) {
  std::vector<DeckTrial> trials = {{.settings = {RankSplit::axis, 0.01}},
                                   {.settings = {RankSplit::axis, 0.02}}};
  add_piece(trials[0], 1.0, 30, 5);
  trials[1].refused = "LIGGGHTS stopped half way";
  EXPECT_EQ(fastest_settings(trials), std::nullopt);
  EXPECT_THAT(failure_of<ResultRejected>([&] { static_cast<void>(chosen_settings(trials)); }),
              AllOf(HasSubstr("0.02 m: LIGGGHTS stopped half way"), HasSubstr("`skin_m`")));
}

// 200 steps of 5e-5 s in 2 s: 100 steps a second, 18 s of the mill in an hour.
const Tuning example_tuning{1000,
                            2,
                            5e-5,
                            200,
                            {trial_of(0.01, {3.0}), trial_of(0.01, {2.5}, RankSplit::axis)},
                            {{.settings = {RankSplit::axis, 0.001}, .refused = "too thin"},
                             trial_of(0.01, {2.5, 2.5, 3.0}, RankSplit::axis),
                             trial_of(0.02, {2.0, 1.0, 4.0}, RankSplit::axis)},
                            {RankSplit::axis, 0.02}};

TEST(Tuning, TellsItsSpeed) {
  const auto& chosen = chosen_trial(example_tuning);
  EXPECT_EQ(chosen.settings, example_tuning.chosen);
  EXPECT_DOUBLE_EQ(steps_per_second(example_tuning, chosen), 100.0);
  EXPECT_DOUBLE_EQ(simulated_seconds_per_hour(example_tuning, chosen), 18.0);
  EXPECT_EQ(spoken_speed(example_tuning, chosen), "100");
  EXPECT_EQ(spoken_speed(example_tuning, example_tuning.skin_trials[1]), "80");
  EXPECT_EQ(dem_lines(example_tuning), "skin_m = 0.02\nrank_split = \"axis\"");
  EXPECT_THAT(tuning_text(example_tuning),
              AllOf(HasSubstr("refused: too thin"), HasSubstr("[dem]\nskin_m = 0.02\nrank_split")));
}

TEST(Tuning, TellsNothingOfASplitWhereThereIsNoChoice) {
  Tuning tuning = example_tuning;
  tuning.split_trials.clear();
  EXPECT_EQ(dem_lines(tuning), "skin_m = 0.02");
}

class TuningFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal_of(const std::string& text) const {
    put_text(file, text);
    return failure_of<ResultRejected>([&] { static_cast<void>(read_tuning(file)); });
  }

  TemporaryFolder place;
  std::filesystem::path file = place.path() / "tuning.json";
};

TEST_F(TuningFile, IsReadAsItWasWritten) {
  put_text(file, tuning_json(example_tuning));
  EXPECT_EQ(tuning_json(read_tuning(file)), tuning_json(example_tuning));
}

TEST_F(TuningFile, OfAnotherKindOrVersionIsRefused) {
  const auto changed = [](const std::string& old, const std::string& replacement) {
    std::string text = tuning_json(example_tuning);
    return text.replace(text.find(old), old.size(), replacement);
  };
  EXPECT_THAT(refusal_of(changed("millwear tuning", "millwear measured")),
              AllOf(HasSubstr(file.string()), HasSubstr("not a millwear tuning of version 2")));
  EXPECT_THAT(refusal_of(changed("\"format_version\": 2", "\"format_version\": 3")),
              HasSubstr("not a millwear tuning of version 2"));
  EXPECT_THAT(refusal_of(changed("\"rank_split\": \"axis\"", "\"rank_split\": \"x\"")),
              HasSubstr("rank_split `x`"));
  EXPECT_THAT(refusal_of(changed("\"skin_m\": 0.02,\n \"skin_t", "\"skin_m\": 0.03,\n \"skin_t")),
              HasSubstr("0.03 m was not tried"));
  EXPECT_NE(refusal_of("{"), "");
}

class TunedCampaign : public TuningFile {
 protected:
  TunedCampaign() {
    campaign.mill.dem.tune = true;
    const auto stage = campaign.folder.stage({0, StageKind::tune});
    std::filesystem::create_directories(stage);
    put_text(stage / stage_files::tuning, tuning_json(example_tuning));
  }

  Campaign campaign{example_case(), {place.path()}, 1};
};

TEST_F(TunedCampaign, WritesLaterDecksWithTheChosenSettings) {
  EXPECT_EQ(case_of_stretch(campaign, {0, StageKind::mix}).dem.skin, std::nullopt);
  EXPECT_EQ(case_of_stretch(campaign, {0, StageKind::mix}).dem.rank_split, std::nullopt);
  for (const StageId stage :
       {StageId{0, StageKind::dem}, StageId{3, StageKind::mix}, StageId{3, StageKind::dem}}) {
    EXPECT_EQ(case_of_stretch(campaign, stage).dem.skin, 0.02) << name_of(stage);
    EXPECT_EQ(case_of_stretch(campaign, stage).dem.rank_split, RankSplit::axis) << name_of(stage);
    // A stage may write this case down for the recorder, which reads it like any other.
    const std::string written = locked_case_text(case_of_stretch(campaign, stage));
    EXPECT_NO_THROW(static_cast<void>(case_from_text(written, "written.toml")));
  }
}

TEST_F(TunedCampaign, KeepsToTheCaseWhereThatDoesNotTune) {
  campaign.mill.dem.tune = false;
  EXPECT_EQ(case_of_stretch(campaign, {0, StageKind::dem}).dem.skin, std::nullopt);
}

TEST_F(TunedCampaign, DoesNotGoOnWithoutItsChoice) {
  std::filesystem::remove_all(campaign.folder.stage({0, StageKind::tune}));
  EXPECT_THROW(static_cast<void>(case_of_stretch(campaign, {0, StageKind::dem})), DiskError);
}

}  // namespace
}  // namespace millwear::orchestrator
