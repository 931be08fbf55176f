#include <gmock/gmock.h>

#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/stages/mesh_stage.h"
#include "orchestrator/stages/wear_stage.h"
#include "orchestrator/stretch/stretch_decks.h"
#include "tests/support/example_case.h"
#include "tests/support/example_measurement.h"
#include "tests/support/temporary_folder.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr double hour = 3600.0;

/// A campaign whose charge wears the top of the lifter.
class OperatedCampaign : public testing::Test {
 protected:
  void keep_load(int cycle) const {
    const auto stage = campaign.folder.stage({cycle, StageKind::dem});
    std::filesystem::create_directories(stage);
    const LinerProfile liner = dem_liner_of_cycle(campaign, cycle);
    wear::LoadAccumulator accumulator(liner, example_measurement(campaign.mill));
    for (int i = 0; i < 100; ++i) {
      const double angle = liner.sector.pitch() * (0.004 * (i % 50) - 0.1);
      const double radius = crest_radius(liner);
      WallContact contact{};
      contact.point = {radius * std::sin(angle), 0.1, -radius * std::cos(angle)};
      contact.into_wall = contact.point.normalized();
      contact.normal_force = 100.0;
      contact.slip_speed = 0.5;
      contact.particle = 1;
      accumulator.add({0.01 * i, 0.0, {contact}});
    }
    wear::write_record(stage / stage_files::load, accumulator.finish());
  }

  [[nodiscard]] Outcome wear(int cycle) const {
    keep_load(cycle);
    const auto into = campaign.folder.stage({cycle, StageKind::wear});
    std::filesystem::create_directories(into);
    return wear_stage(campaign, cycle, into);
  }

  /// Milled in the first cycle where nothing changes [s].
  [[nodiscard]] double usual_time() const {
    static_cast<void>(wear(0));
    return milling_time_before(campaign, 1);
  }

  std::vector<OperatingChange>& changes() { return campaign.mill.campaign.operation; }

  TemporaryFolder place;
  Campaign campaign{example_case(), {place.path()}, 1};
};

TEST_F(OperatedCampaign, EndsACycleAtTheTimeOfAChange) {
  const double time = 0.6 * usual_time();
  changes() = {{.from_time = time, .speed = 4.0}};
  EXPECT_EQ(wear(0), Outcome::changed);
  EXPECT_NEAR(milling_time_before(campaign, 1), time, 1e-3);
  EXPECT_EQ(as_operated(campaign, 0).mill.speed, campaign.mill.speed);
  EXPECT_EQ(as_operated(campaign, 1).mill.speed, 4.0);
  EXPECT_EQ(first_cycle_of_operation(campaign, 1), 1);
  EXPECT_EQ(rotation_of_cycle(campaign, 1), Rotation::as_new);
}

TEST_F(OperatedCampaign, EndsACycleAtTheHeightOfAChange) {
  static_cast<void>(usual_time());
  const double height =
      0.5 * (lifter_height(campaign.mill.liner) + lifter_height(liner_of_cycle(campaign, 1)));
  changes() = {{.from_height = height, .counts = {100, 1000, 2000}}};
  EXPECT_EQ(wear(0), Outcome::changed);
  EXPECT_NEAR(lifter_height(liner_of_cycle(campaign, 1)), height, 2e-6);
  EXPECT_EQ(as_operated(campaign, 1).mill.charge.classes[2].count, 2000u);
  EXPECT_NE(wear(1), Outcome::changed);
  EXPECT_EQ(first_cycle_of_operation(campaign, 2), 1);
}

TEST_F(OperatedCampaign, GoesOnThroughChangesOfFeedAndStops) {
  const double time = usual_time();
  changes() = {{.from_time = 0.5 * time, .feed_rate = 10.0},
               {.from_time = 0.7 * time, .idle_time = 100.0 * hour}};
  EXPECT_EQ(wear(0), Outcome::go_on);
  EXPECT_DOUBLE_EQ(milling_time_before(campaign, 1), time);
  EXPECT_EQ(first_cycle_of_operation(campaign, 1), 0);
  EXPECT_EQ(as_operated(campaign, 1).mill.feed_rate, 10.0);
}

TEST_F(OperatedCampaign, TellsAReversalFromAnotherChange) {
  changes() = {{.from_time = 0.6 * usual_time(), .rotation = Rotation::reversed}};
  EXPECT_EQ(wear(0), Outcome::reversed);
  EXPECT_EQ(rotation_of_cycle(campaign, 1), Rotation::reversed);
}

// The DEM of the cycle after a change starts from its own mixing, at the speed and with the charge
// then in force, and the recorder is told of that mill.
TEST_F(OperatedCampaign, MeasuresTheMillAsItIsOperated) {
  changes() = {{.from_time = 0.6 * usual_time(), .speed = 4.0, .counts = {90, 1000, 3000}}};
  campaign.mill.dem.contact_path = ContactPath::recorder;
  campaign.mill.dem.sample_every_steps = 1;
  static_cast<void>(wear(0));
  const Campaign operated = as_operated(campaign, 1);
  const auto mesh = campaign.folder.stage({1, StageKind::mesh});
  std::filesystem::create_directories(mesh);
  mesh_stage(operated, 1, mesh);
  const auto dem = campaign.folder.stage({1, StageKind::dem});
  std::filesystem::create_directories(dem);
  write_measuring_deck(operated, 1, dem);
  EXPECT_THAT(read_file(dem / "deck.in"), HasSubstr("../mix/charge.restart"));
  const std::string told = read_file(dem / "case_as_operated.toml");
  EXPECT_THAT(told, HasSubstr("count = 90\n"));
  EXPECT_THAT(told, Not(HasSubstr("campaign.operation")));
  EXPECT_EQ(case_from_text(told, "told.toml").speed, 4.0);
  EXPECT_THAT(recorder_arguments(operated.mill, 1), testing::Contains("case_as_operated.toml"));
}

}  // namespace
}  // namespace millwear::orchestrator
