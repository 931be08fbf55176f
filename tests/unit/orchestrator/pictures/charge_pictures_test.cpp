#include "orchestrator/pictures/charge_pictures.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/sample_frames.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_folder.h"
#include "wear/charge/charge_record.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::StartsWith;

/// Three cycles without a DEM, of which the last two have a charge.
class ChargePictures : public ::testing::Test {
 protected:
  void SetUp() override {
    for (auto& entry : run.ledger.entries)
      if (entry.stage.kind == StageKind::dem && entry.stage.cycle > 0) add_charge(entry);
    charge = charge_of_cycles(run.campaign, {0, 1, 2});
  }

  void add_charge(LedgerEntry& entry) const {
    const auto& mill = run.campaign.mill;
    wear::ChargeFieldSums sums({mill.liner.sector.shell_radius, 16}, mill.slice_length,
                               mill.charge.classes.size());
    sums.begin_instant();
    sums.add({{-0.25, 0.1, -0.25}, {1.0, 0.0, 1.0}, 0.05, 4.0, 0});
    sums.add_pair_time(1.0);
    const fs::path file = run.campaign.folder.stage(entry.stage) / stage_files::charge;
    wear::write_charge(file, {sums.fields(), wear::sample_frames()});
    entry.outputs[stage_files::charge] = hash_of_file(file);
  }

  bool draw(const std::set<int>& chosen) {
    return draw_charge_pictures(run.campaign, run.ledger, chosen, charge);
  }

  [[nodiscard]] fs::path png(const std::string& name) const {
    return run.campaign.folder.results() / "pictures" / (name + ".png");
  }

  const TemporaryFolder folder;
  SyntheticRun run = synthetic_run(folder.path(), 3);
  ShownCharge charge;
};

TEST_F(ChargePictures, AreDrawnOnceOfEveryCycleThatHasACharge) {
  ASSERT_EQ(charge.cycles.size(), 2U);
  EXPECT_TRUE(draw({2}));
  EXPECT_TRUE(fs::exists(png("cycle_001_section")));
  EXPECT_FALSE(fs::exists(png("cycle_001_streaks"))) << "which was not chosen";
  for (const auto* name : {"section", "section_by_size", "close_up", "slice", "streaks",
                           "occupancy", "velocity", "collision_power", "segregation", "polar"})
    EXPECT_THAT(read_file(png("cycle_002_" + std::string(name))), StartsWith("\x89PNG")) << name;
  EXPECT_FALSE(draw({2}));
  fs::remove(png("cycle_001_section"));
  EXPECT_TRUE(draw({2}));
  EXPECT_TRUE(fs::exists(png("cycle_001_section")));
}

TEST_F(ChargePictures, GoIntoThePageAsJpegAlsoFromWhatWasKept) {
  EXPECT_TRUE(draw({}));
  const auto drawn = charge.cycles[0].pictures;
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_THAT(drawn.at("close_up"), StartsWith("\xff\xd8"));
  ShownCharge again = charge_of_cycles(run.campaign, {0, 1, 2});
  add_kept_pictures(run.campaign, run.ledger, again);
  EXPECT_EQ(again.cycles[0].pictures, drawn);
}

TEST_F(ChargePictures, AreDrawnAnewOfAnotherCharge) {
  EXPECT_TRUE(draw({}));
  for (auto& entry : run.ledger.entries)
    if (entry.stage.cycle == 1) entry.outputs[stage_files::charge] = "another";
  EXPECT_TRUE(draw({}));
}

TEST_F(ChargePictures, WithoutARendererSayWhichPackageHasIt) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_THAT([&] { draw({}); },
              testing::ThrowsMessage<ExternalProgramError>(testing::HasSubstr("tachyon-bin-nox")));
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(fs::exists(run.campaign.folder.results() / "pictures"));
}

TEST_F(ChargePictures, OfOneCycleGoIntoAFolderWithAFrameEach) {
  const fs::path into = folder.path() / "film";
  write_pictures_of_cycle(run.campaign, run.ledger, 2, into);
  EXPECT_TRUE(fs::exists(into / "occupancy.png"));
  EXPECT_TRUE(fs::exists(into / "frame_01.png"));
  EXPECT_FALSE(fs::exists(into / "frame_02.png")) << "there are two frames";
  EXPECT_NE(read_file(into / "frame_00.png"), read_file(into / "frame_01.png"));
  EXPECT_THROW(write_pictures_of_cycle(run.campaign, run.ledger, 0, into), Failure);
}

}  // namespace
}  // namespace millwear::orchestrator
