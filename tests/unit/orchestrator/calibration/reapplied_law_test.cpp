#include "orchestrator/calibration/reapplied_law.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/mill_frame.h"
#include "orchestrator/campaign/case_difference.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/measured.h"
#include "tests/support/example_case.h"
#include "tests/support/example_measurement.h"
#include "tests/support/temporary_folder.h"
#include "wear/rate/load_rate.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double hour = 3600.0;

/// The example mill under `mechanisms`, its 120 bins as the pilot mill's.
Case mill_with(std::vector<WearMechanism> mechanisms) {
  Case mill = example_case();
  mill.wear.mechanisms = std::move(mechanisms);
  return mill;
}

/// Eight cells a bin; the balls slide 1 J in every cell of bins 10 to 49 and bring 1 J of impact in
/// every cell of bins 60 to 99: 320 J each.
WallLoad two_places() {
  const Case mill = example_case();
  const Eigen::Index cells = 8 * mill.wear.bins;
  WallLoad load{};
  load.slice_length = mill.slice_length;
  load.rows = mill.liner.sector.rows;
  load.duration = 2.0;
  load.bin_edges = Eigen::VectorXd::LinSpaced(cells + 1, 0.0, 0.3);
  load.class_count = 3;
  load.block_count = 2;
  load.values.fill(Eigen::MatrixXd::Zero(cells, 6));
  load.values[index_of(Measure::sliding_work)].block(80, 0, 320, 2).setConstant(0.5);
  load.values[index_of(Measure::incident_energy)].block(480, 0, 320, 2).setConstant(0.5);
  return load;
}

// 320 J at 1e-12 m3/J over 0.2 m of 12 lifters and 2 s.
TEST(LawOnLoad, IsExactForAnotherCoefficient) {
  const LawOnLoad law =
      law_on_load(mill_with({{WearLaw::archard, 1e-12}}), mill_with({{WearLaw::archard, 3e-12}}),
                  example_case().liner, two_places());
  EXPECT_NEAR(law.campaign_rate, 320e-12 / (0.2 * 12 * 2.0), 1e-24);
  EXPECT_NEAR(law.section_rate / law.campaign_rate, 3.0, 1e-14);
  EXPECT_EQ(law.elsewhere, 0.0);
  EXPECT_EQ(law.shares, std::vector<double>{1.0});
}

// Impacts where nothing slides: the same volume, all of it elsewhere. The smoothing is zero but for
// one bin beside a loaded stretch, so the two do not overlap.
TEST(LawOnLoad, SeesThatAllWearFallsElsewhere) {
  const LawOnLoad law = law_on_load(mill_with({{WearLaw::archard, 1e-12}}),
                                    mill_with({{WearLaw::incident_energy, 1e-12}}),
                                    example_case().liner, two_places());
  EXPECT_NEAR(law.section_rate / law.campaign_rate, 1.0, 1e-12);
  EXPECT_NEAR(law.elsewhere, 1.0, 1e-12);
}

// One part sliding and three parts impact; 3/4 of the wear is elsewhere.
TEST(LawOnLoad, SharesTheWearAmongMechanisms) {
  const LawOnLoad law =
      law_on_load(mill_with({{WearLaw::archard, 1e-12}}),
                  mill_with({{WearLaw::archard, 1e-12}, {WearLaw::incident_energy, 3e-12}}),
                  example_case().liner, two_places());
  EXPECT_NEAR(law.shares.at(0), 0.25, 1e-12);
  EXPECT_NEAR(law.shares.at(1), 0.75, 1e-12);
  EXPECT_NEAR(law.elsewhere, 0.75, 0.02);
}

// Nothing rests on a measure that stays empty.
TEST(LawOnLoad, WithoutWearHasNoShares) {
  const LawOnLoad law =
      law_on_load(mill_with({{WearLaw::archard, 1e-12}}), mill_with({{WearLaw::finnie, 1e-12}}),
                  example_case().liner, two_places());
  EXPECT_EQ(law.section_rate, 0.0);
  EXPECT_TRUE(std::isnan(law.elsewhere));
  EXPECT_TRUE(std::isnan(law.shares.front()));
}

wear::LoadRate rate_under(const std::vector<WearMechanism>& mechanisms) {
  const Case mill = mill_with(mechanisms);
  return wear::rate_of_load(mill.wear, mill.charge.classes, mill.liner, two_places());
}

// Corrosion is added after the smoothing: bins without contact lose exactly its rate, the others
// exactly as much more than without it, and the volume is that of both.
TEST(RateOfLoad, AddsCorrosionExactlyConstant) {
  const double corrosion = 2e-10;
  const auto alone = rate_under({{WearLaw::archard, 1e-12}});
  const auto both = rate_under({{WearLaw::archard, 1e-12}, {WearLaw::corrosion, 0.0, corrosion}});
  const Eigen::VectorXd expected = alone.smoothed.rate.values.array() + corrosion;
  EXPECT_EQ(both.smoothed.rate.values, expected);
  EXPECT_EQ(both.raw[0], corrosion);
  EXPECT_EQ(both.smoothed.rate.values[0], corrosion);
  EXPECT_NEAR(both.raw.sum(), both.smoothed.rate.values.sum(), 1e-12 * both.raw.sum());
  const double moved = (both.smoothed.rate.values - both.raw).lpNorm<1>();
  EXPECT_NEAR(both.smoothed.moved_share, 0.5 * moved / both.raw.sum(), 1e-12);
}

TEST(RateOfLoad, TakesCorrosionAlone) {
  const auto rate = rate_under({{WearLaw::corrosion, 0.0, 2e-10}});
  EXPECT_EQ(rate.smoothed.rate.values.minCoeff(), 2e-10);
  EXPECT_EQ(rate.smoothed.rate.values.maxCoeff(), 2e-10);
  EXPECT_EQ(rate.smoothed.moved_share, 0.0);
}

/// A campaign of the example mill as its folder keeps it: cycle 0 worn in steps of one and two
/// hours to a lifter of 30 mm, cycle 1 measured.
class KeptCampaign : public testing::Test {
 protected:
  void SetUp() override {
    put_text(folder.locked_case(), locked_case_text(mill));
    write_ledger(folder.ledger(), {{"millwear", "hash", 1, "host"}, {}});
    keep_load(0);
    const StageId worn{0, StageKind::wear};
    std::filesystem::create_directories(folder.stage(worn));
    const auto steps = folder.stage(worn) / stage_files::steps;
    LinerProfile lower = mill.liner;
    for (auto& node : lower.nodes) node.y() = std::min(node.y(), 0.03);
    write_cycle(steps, {0.0, 0.0, {{hour, 0, 0, 0, mill.liner}, {2 * hour, 0, 0, 0, lower}}});
    append_entry(folder.ledger(),
                 {worn, Outcome::go_on, {{stage_files::steps, hash_of_file(steps)}}, 1.0});
    keep_load(1);
  }

  void keep_load(int cycle) {
    const StageId stage{cycle, StageKind::dem};
    std::filesystem::create_directories(folder.stage(stage));
    const auto file = folder.stage(stage) / stage_files::load;
    wear::LoadAccumulator accumulator(mill.liner, example_measurement(mill));
    for (int i = 0; i < 100; ++i) {
      WallContact contact{};
      contact.point = to_mill_point(1e-3 * (i % 20 - 10));
      contact.into_wall = contact.point.normalized();
      contact.normal_force = 100.0;
      contact.slip_speed = 0.5;
      contact.shear_power = 15.0;
      contact.particle = 1;
      accumulator.add({0.01 * i, 0.0, {contact}});
    }
    wear::write_record(file, accumulator.finish());
    append_entry(folder.ledger(),
                 {stage, Outcome::go_on, {{stage_files::load, hash_of_file(file)}}, 1.0});
  }

  /// A place on the lifter's top, `xi` from its middle, in the mill at angle 0.
  [[nodiscard]] Eigen::Vector3d to_mill_point(double xi) const {
    const auto xz = to_mill(mill.liner.sector, {xi, 0.04}, 0, 0.0);
    return {xz.x(), 0.1, xz.y()};
  }

  [[nodiscard]] std::map<std::string, std::string> everything() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.root))
      if (entry.is_regular_file()) files[entry.path().string()] = hash_of_file(entry.path());
    return files;
  }

  TemporaryFolder place;
  RunFolder folder{place.path()};
  Case mill = example_case();
};

// Twice the coefficient halves 1 h + 2 h; cycle 1 is not worn yet and has a rate alone. 100 samples
// of 100 N x 0.5 m/s x 0.01 s are 50 J.
TEST_F(KeptCampaign, GivesTheHoursOfAnotherCoefficient) {
  const ReappliedLaw law = reapply(mill_with({{WearLaw::archard, 2e-12}}), folder);
  ASSERT_EQ(law.cycles.size(), 2U);
  EXPECT_NEAR(law.cycles[0].law.section_rate, 2e-12 * 50.0 / (0.2 * 12 * 1.0), 1e-24);
  EXPECT_NEAR(law.cycles[0].lifter_height, 0.04, 1e-12);
  EXPECT_NEAR(law.cycles[1].lifter_height, 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(law.cycles[1].hours));
  EXPECT_DOUBLE_EQ(law.campaign_hours, 3.0);
  EXPECT_NEAR(law.hours, 1.5, 1e-12);
  EXPECT_EQ(law.elsewhere, 0.0);
  EXPECT_FALSE(law.life_reached);
  EXPECT_NEAR(law.lifter_height, 0.03, 1e-12);
}

// The same 50 J slide, of which 15 W x 1 s are the work of friction: at the same k, 15/50 of it.
TEST_F(KeptCampaign, GivesTheHoursOfAnotherLaw) {
  const ReappliedLaw law = reapply(mill_with({{WearLaw::shear_dissipation, 1e-12}}), folder);
  EXPECT_NEAR(law.cycles[0].law.section_rate / law.cycles[0].law.campaign_rate, 0.3, 1e-12);
  EXPECT_NEAR(law.hours, 10.0, 1e-9);
}

TEST_F(KeptCampaign, IsNotTouched) {
  const auto before = everything();
  const ReappliedLaw law = reapply(mill_with({{WearLaw::finnie, 2e-12}}), folder);
  EXPECT_FALSE(wear_rates(law, folder).empty());
  EXPECT_EQ(everything(), before);
}

// Two cycles, two mechanisms, 120 bins; the sum over the bins is the section rate.
TEST_F(KeptCampaign, GivesTheRateOfEveryBinByMechanism) {
  const ReappliedLaw law =
      reapply(mill_with({{WearLaw::archard, 2e-12}, {WearLaw::corrosion, 0.0, 1e-12}}), folder);
  const auto rows = wear_rates(law, folder);
  ASSERT_EQ(rows.size(), 2U * 2U * 120U);
  const double width = arc_lengths(mill.liner).back() / 120.0;
  double section = 0.0;
  for (const auto& row : rows)
    if (row.cycle == 0) section += row.depth_rate * width;
  EXPECT_NEAR(section / law.cycles[0].law.section_rate, 1.0, 1e-12);
  EXPECT_EQ(rows[120].law, "corrosion");
  EXPECT_EQ(rows[120].depth_rate, 1e-12);
  EXPECT_EQ(rows[120].depth_rate_error, 0.0);
  EXPECT_NEAR(rows[1].arc_length, 1.5 * width, 1e-12);
}

TEST_F(KeptCampaign, RefusesAnotherMillByNamingWhatDiffers) {
  Case other = mill_with({{WearLaw::archard, 2e-12}});
  other.file = "other.toml";
  other.campaign.height_limit = 0.02;
  EXPECT_NO_THROW(static_cast<void>(reapply(other, folder)));
  other.dem.seed = 2;
  other.wear.excess_speed = 0.3;
  other.charge.classes[1].count = 999;
  EXPECT_THAT(failure_of<InputError>([&] { static_cast<void>(reapply(other, folder)); }),
              AllOf(HasSubstr("other.toml: the loads in " + folder.root.string()),
                    HasSubstr("[dem] `seed` (2, there 1)"),
                    HasSubstr("[wear] `excess_speed_m_per_s` (0.3, there 0.1)"),
                    HasSubstr("[[charge.counts]] number 2 `count` (999, there 1000)"),
                    HasSubstr("only the laws of [wear] and [campaign] may differ")));
}

TEST_F(KeptCampaign, RefusesALoadThatWasChanged) {
  std::ofstream(folder.stage({1, StageKind::dem}) / stage_files::load, std::ios::app) << "x";
  EXPECT_THAT(failure_of<ResultRejected>([&] { static_cast<void>(reapply(mill, folder)); }),
              HasSubstr("load.h5"));
}

TEST(ReappliedLaw, RefusesAFolderWithoutACampaignOrALoad) {
  const TemporaryFolder place;
  const RunFolder folder{place.path()};
  const auto refusal = [&] {
    return failure_of<Failure>([&] { static_cast<void>(reapply(example_case(), folder)); });
  };
  EXPECT_THAT(refusal(), HasSubstr("no campaign is here"));
  put_text(folder.locked_case(), locked_case_text(example_case()));
  write_ledger(folder.ledger(), {{"millwear", "hash", 1, "host"}, {}});
  EXPECT_THAT(refusal(), HasSubstr("the campaign has no load yet"));
}

TEST(CaseDifference, NamesKeysThatOnlyOneHas) {
  const Case here = mill_with({{WearLaw::archard, 1e-12}});
  Case there = here;
  there.dem.skin = 0.01;
  EXPECT_EQ(differences(here, here), std::vector<std::string>{});
  EXPECT_EQ(differences(here, there),
            std::vector<std::string>{"[dem] `skin_m` (none, there 0.01)"});
  EXPECT_EQ(differences(there, here),
            std::vector<std::string>{"[dem] `skin_m` (0.01, there none)"});
}

}  // namespace
}  // namespace millwear::orchestrator
