#include <gmock/gmock.h>

#include <stdexcept>

#include "orchestrator/campaign/stage_order.h"
#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

const Ledger new_ledger{{"millwear", "hash", 1, "host"}, {}};

struct Stopped : std::runtime_error {
  using runtime_error::runtime_error;
};

/// Where an effect fails, counted over all effects of a campaign.
enum class FailingEffect { none, run_stage, record, after_cycle };

/// A disk that remembers what was recorded, and a campaign that wears the liner out in cycle
/// `last_cycle`.
struct FakeWorld {
  int last_cycle;
  Outcome last_outcome = Outcome::height_limit;
  FailingEffect failing = FailingEffect::none;
  int fails_after = 0;
  int reversed_after = -1;  ///< the cycle whose steps end at a reversal

  std::vector<std::string> published{};
  std::vector<std::size_t> gathered{};
  Ledger on_disk = new_ledger;

  void maybe_fail(FailingEffect effect) {
    if (effect == failing && fails_after-- == 0) throw Stopped("stopped");
  }

  CampaignEffects effects() {
    return {[this](const StageId& stage) {
              maybe_fail(FailingEffect::run_stage);
              published.push_back(name_of(stage));
              const bool ends = stage == StageId{last_cycle, StageKind::wear};
              const bool turns = stage == StageId{reversed_after, StageKind::wear};
              return LedgerEntry{stage,
                                 ends    ? last_outcome
                                 : turns ? Outcome::reversed
                                         : Outcome::go_on,
                                 {},
                                 1.0};
            },
            [this](const LedgerEntry& entry) {
              maybe_fail(FailingEffect::record);
              on_disk.entries.push_back(entry);
            },
            [this](const Ledger& so_far) {
              maybe_fail(FailingEffect::after_cycle);
              gathered.push_back(so_far.entries.size());
            }};
  }

  [[nodiscard]] std::vector<std::string> recorded() const {
    std::vector<std::string> names;
    for (const auto& entry : on_disk.entries) names.push_back(name_of(entry.stage));
    return names;
  }
};

const std::vector<std::string> stages_of_two_cycles = {
    "cycle 0 mesh", "cycle 0 mix", "cycle 0 dem", "cycle 0 wear",
    "cycle 1 mesh", "cycle 1 dem", "cycle 1 wear"};

TEST(Campaign, MixesOnceAndGathersAfterEveryWear) {
  FakeWorld world{.last_cycle = 1};
  const Ledger finished = run_campaign(new_ledger, {20}, world.effects());
  EXPECT_THAT(world.published, ElementsAreArray(stages_of_two_cycles));
  EXPECT_THAT(world.gathered, ElementsAre(4, 7));
  EXPECT_EQ(finished.entries.size(), 7u);
}

class CampaignStops : public testing::TestWithParam<Outcome> {};

TEST_P(CampaignStops, AtALimitOfTheLiner) {
  FakeWorld world{.last_cycle = 0, .last_outcome = GetParam()};
  const Ledger finished = run_campaign(new_ledger, {20}, world.effects());
  EXPECT_EQ(world.published.back(), "cycle 0 wear");
  EXPECT_EQ(outcome_of(finished), GetParam());
  EXPECT_FALSE(next_stage(finished, {20}));
}

INSTANTIATE_TEST_SUITE_P(Campaign, CampaignStops,
                         testing::Values(Outcome::height_limit, Outcome::plate_limit));

TEST(Campaign, StopsAtItsLastCycleAndGoesOnWhenThatIsRaised) {
  FakeWorld world{.last_cycle = 100};
  const Ledger one_cycle = run_campaign(new_ledger, {1}, world.effects());
  EXPECT_EQ(world.published.back(), "cycle 0 wear");
  EXPECT_EQ(outcome_of(one_cycle), Outcome::go_on);
  EXPECT_EQ(next_stage(one_cycle, {2})->stage, (StageId{1, StageKind::mesh}));
}

TEST(Campaign, RunsNoFurtherThanAStage) {
  FakeWorld world{.last_cycle = 1};
  CampaignPlan plan{20};
  plan.until = StageId{0, StageKind::dem};
  const Ledger some = run_campaign(new_ledger, plan, world.effects());
  EXPECT_EQ(world.published.back(), "cycle 0 dem");
  world.published.clear();
  const Ledger same = run_campaign(some, plan, world.effects());
  EXPECT_THAT(world.published, IsEmpty());
  run_campaign(same, {20}, world.effects());
  EXPECT_EQ(world.published.front(), "cycle 0 wear");
}

TEST(Campaign, FinishedOneRunsNothing) {
  FakeWorld world{.last_cycle = 1};
  const Ledger finished = run_campaign(new_ledger, {20}, world.effects());
  world.published.clear();
  run_campaign(finished, {20}, world.effects());
  EXPECT_THAT(world.published, IsEmpty());
}

// The mirrored steel may stand where the charge lies: the cycle after a reversal mixes anew, and
// only that one.
TEST(Campaign, MixesAnewAfterAReversal) {
  FakeWorld world{.last_cycle = 2, .reversed_after = 0};
  const Ledger finished = run_campaign(new_ledger, {20}, world.effects());
  EXPECT_THAT(world.published,
              ElementsAre("cycle 0 mesh", "cycle 0 mix", "cycle 0 dem", "cycle 0 wear",
                          "cycle 1 mesh", "cycle 1 mix", "cycle 1 dem", "cycle 1 wear",
                          "cycle 2 mesh", "cycle 2 dem", "cycle 2 wear"));
  EXPECT_EQ(outcome_of(finished), Outcome::height_limit);
}

TEST(Campaign, GoesOnWhereItStoppedAfterAReversal) {
  FakeWorld world{.last_cycle = 9, .reversed_after = 0};
  const Ledger reversed = run_campaign(new_ledger, {1}, world.effects());
  EXPECT_EQ(outcome_of(reversed), Outcome::go_on);
  EXPECT_EQ(next_stage(reversed, {2})->why, "the mill was reversed after cycle 0 wear");
}

TEST(Campaign, SaysWhyAStageIsNext) {
  EXPECT_EQ(next_stage(new_ledger, {20})->why, "the campaign is new");
  Ledger meshed = new_ledger;
  meshed.entries.push_back({{0, StageKind::mesh}, Outcome::go_on, {}, 1.0});
  EXPECT_EQ(next_stage(meshed, {20})->why, "cycle 0 mesh is published and this is not");
}

TEST(Campaign, TriesForSpeedOnceAfterTheFirstMix) {
  FakeWorld world{.last_cycle = 1, .reversed_after = 0};
  run_campaign(new_ledger, {20, SpeedTrial::after_first_mix}, world.effects());
  EXPECT_THAT(world.published, ElementsAre("cycle 0 mesh", "cycle 0 mix", "cycle 0 tune",
                                           "cycle 0 dem", "cycle 0 wear", "cycle 1 mesh",
                                           "cycle 1 mix", "cycle 1 dem", "cycle 1 wear"));
}

TEST(Campaign, TriesForSpeedWhereTheCaseWantsIt) {
  Case mill = example_case();
  EXPECT_EQ(plan_of(mill).trial, SpeedTrial::none);
  mill.dem.tune = true;
  EXPECT_EQ(plan_of(mill).trial, SpeedTrial::after_first_mix);
  EXPECT_EQ(plan_of(mill).cycle_limit, mill.campaign.cycle_limit);
}

struct FailurePoint {
  FailingEffect effect;
  int after;
};

class CampaignResumes : public testing::TestWithParam<FailurePoint> {};

// Wherever an effect fails, the next call goes on from the ledger on disk: every stage is recorded
// once and in order, and only a stage that was run but not recorded runs a second time.
TEST_P(CampaignResumes, WithTheSameStagesOnceEach) {
  const auto [effect, after] = GetParam();
  FakeWorld world{.last_cycle = 1, .failing = effect, .fails_after = after};
  EXPECT_THROW(run_campaign(new_ledger, {20}, world.effects()), Stopped);
  world.failing = FailingEffect::none;
  const Ledger finished = run_campaign(world.on_disk, {20}, world.effects());
  EXPECT_THAT(world.recorded(), ElementsAreArray(stages_of_two_cycles));
  EXPECT_EQ(outcome_of(finished), Outcome::height_limit);
  EXPECT_EQ(world.published.size(), effect == FailingEffect::record ? 8u : 7u);
}

std::vector<FailurePoint> every_failure_point() {
  std::vector<FailurePoint> points = {{FailingEffect::after_cycle, 0},
                                      {FailingEffect::after_cycle, 1}};
  for (int stage = 0; stage < 7; ++stage) {
    points.push_back({FailingEffect::run_stage, stage});
    points.push_back({FailingEffect::record, stage});
  }
  return points;
}

INSTANTIATE_TEST_SUITE_P(Campaign, CampaignResumes, testing::ValuesIn(every_failure_point()));

}  // namespace
}  // namespace millwear::orchestrator
