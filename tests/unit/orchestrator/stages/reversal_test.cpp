#include <gmock/gmock.h>

#include "mill/base/whole_file.h"
#include "mill/liner/mill_frame.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/stages/mesh_stage.h"
#include "orchestrator/stages/run_stage.h"
#include "orchestrator/stages/wear_stage.h"
#include "orchestrator/stretch/stretch_decks.h"
#include "tests/support/example_case.h"
#include "tests/support/example_measurement.h"
#include "tests/support/temporary_folder.h"
#include "wear/evolve/load_carrier.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

constexpr double turn_time = 2000.0 * 3600.0;

/// The example mill with a symmetrical lifter, reversed after 2000 and 4000 hours.
Case turning_mill() {
  Case mill = example_case();
  mill.liner = profile_of(mill.liner.sector, {0.04, 0.05, 0.3, 0.3});
  mill.campaign.reversal_times = {turn_time, 2.0 * turn_time};
  return mill;
}

/// A campaign whose charge always slides over the face that leads, in the DEM's frame.
class TurningCampaign : public testing::Test {
 protected:
  void keep_load(int cycle) const {
    const auto& mill = campaign.mill;
    const auto stage = campaign.folder.stage({cycle, StageKind::dem});
    std::filesystem::create_directories(stage);
    const LinerProfile liner = dem_liner_of_cycle(campaign, cycle);
    const auto lengths = arc_lengths(liner);
    wear::LoadAccumulator accumulator(liner, example_measurement(mill));
    for (int i = 0; i < 100; ++i) {
      const double share = 0.53 + 0.002 * (i % 50);
      const auto spot = wear::place_at(liner, lengths, share * lengths.back());
      const auto xz = to_mill(liner.sector, spot, 0, 0.0);
      WallContact contact{};
      contact.point = {xz.x(), 0.1, xz.y()};
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

  TemporaryFolder place;
  Campaign campaign{turning_mill(), {place.path()}, 1};
};

/// Section on the side of the face that led when the liner was new, less that on the other [m2].
double asymmetry(const LinerProfile& liner) {
  const auto steel_ahead = [](const LinerProfile& profile) {
    double section = 0.0;
    for (std::size_t i = 1; i < profile.nodes.size(); ++i) {
      const Eigen::Vector2d a = profile.nodes[i - 1].cwiseMax(Eigen::Vector2d(0.0, -1.0));
      const Eigen::Vector2d b = profile.nodes[i].cwiseMax(Eigen::Vector2d(0.0, -1.0));
      section += 0.5 * (a.y() + b.y()) * (b.x() - a.x());
    }
    return section;
  };
  return steel_ahead(liner) - steel_ahead(mirrored(liner));
}

// As long one way as the other: the faces come out alike, to the half of the threshold's step by
// which the second load begins on another shape.
TEST_F(TurningCampaign, WearsBothFaces) {
  EXPECT_EQ(wear(0), Outcome::reversed);
  EXPECT_NEAR(milling_time_before(campaign, 1), turn_time, 1e-3);
  EXPECT_EQ(rotation_of_cycle(campaign, 1), Rotation::reversed);
  const double one_way = asymmetry(liner_of_cycle(campaign, 1));
  EXPECT_LT(one_way, -1e-5);

  EXPECT_EQ(wear(1), Outcome::reversed);
  const auto worn = campaign.folder.stage({1, StageKind::wear}) / stage_files::steps;
  const auto on_the_way = read_cycle(worn, campaign.mill.liner.sector).steps.front().profile;
  EXPECT_LT(asymmetry(on_the_way), 0.2 * one_way);
  EXPECT_NEAR(milling_time_before(campaign, 2), 2.0 * turn_time, 1e-3);
  EXPECT_EQ(rotation_of_cycle(campaign, 2), Rotation::as_new);
  EXPECT_LT(std::abs(asymmetry(liner_of_cycle(campaign, 2))), 0.05 * std::abs(one_way));
}

TEST_F(TurningCampaign, WithoutReversalsWearsOneFace) {
  campaign.mill.campaign.reversal_times.clear();
  EXPECT_EQ(wear(0), Outcome::go_on);
  EXPECT_GT(milling_time_before(campaign, 1), turn_time);
  EXPECT_EQ(rotation_of_cycle(campaign, 1), Rotation::as_new);
  EXPECT_EQ(dem_liner_of_cycle(campaign, 1).nodes, liner_of_cycle(campaign, 1).nodes);
  EXPECT_EQ(first_cycle_of_operation(campaign, 1), 0);
}

// The DEM of the cycle after a reversal stands on the mirror image, and starts from its own mixing.
TEST_F(TurningCampaign, BeginsTheReversedDemAnewOnTheMirrorImage) {
  static_cast<void>(wear(0));
  EXPECT_EQ(first_cycle_of_operation(campaign, 1), 1);
  const auto mesh = campaign.folder.stage({1, StageKind::mesh});
  make_folder(mesh);
  mesh_stage(campaign, 1, mesh);
  const auto meshed = read_profile_csv(mesh / stage_files::profile, campaign.mill.liner.sector);
  EXPECT_NEAR(asymmetry(meshed), -asymmetry(liner_of_cycle(campaign, 1)), 1e-12);

  const auto dem = campaign.folder.stage({1, StageKind::dem});
  make_folder(dem);
  write_measuring_deck(campaign, 1, dem);
  EXPECT_THAT(read_file(dem / "deck.in"), HasSubstr("../mix/charge.restart"));
}

// A limit had been passed already: nothing was worn, and the liner is the one it began with.
TEST_F(TurningCampaign, LeavesTheLinerWhereNoStepWasTaken) {
  const auto worn = campaign.folder.stage({0, StageKind::wear});
  std::filesystem::create_directories(worn);
  write_cycle(worn / stage_files::steps, {0.0, 0.0, {}});
  EXPECT_EQ(liner_of_cycle(campaign, 1).nodes, campaign.mill.liner.nodes);
}

}  // namespace
}  // namespace millwear::orchestrator
