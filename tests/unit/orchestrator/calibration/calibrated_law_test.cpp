#include "orchestrator/calibration/calibrated_law.h"

#include <gmock/gmock.h>

#include <cmath>

#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/calibration/calibration_text.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/dem_run/measured.h"
#include "tests/support/example_case.h"
#include "tests/support/example_measurement.h"
#include "tests/support/temporary_folder.h"
#include "wear/evolve/evolution.h"
#include "wear/rate/load_rate.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_write.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double hour = 3600.0;

/// Sliding everywhere alike, impacts on the leading half alone: each of the energy that wears 10 um
/// an hour at k = 1e-12 1/Pa.
wear::LinerRecord record_on(const Case& mill, const LinerProfile& liner) {
  wear::LoadAccumulator accumulator(liner, example_measurement(mill));
  for (int i = 0; i < 100; ++i) accumulator.add({0.01 * i, 0.0, {}});
  wear::LinerRecord record = accumulator.finish();
  WallLoad& load = record.load;
  const double energy = 1e-5 / hour / 1e-12 * load.bin_area()[0] * load.rows * load.duration /
                        static_cast<double>(load.block_count);
  const auto blocks = static_cast<Eigen::Index>(load.block_count);
  load.values[index_of(Measure::sliding_work)].leftCols(blocks).setConstant(energy);
  load.values[index_of(Measure::excess_energy)]
      .leftCols(blocks)
      .bottomRows(load.bins() / 2)
      .setConstant(energy);
  return record;
}

/// Two worn cycles of the example mill under Archard's law of 1e-12 1/Pa, 10 um an hour, and the
/// load of a third.
class CalibratedCampaign : public testing::Test {
 protected:
  void SetUp() override {
    put_text(folder.locked_case(), locked_case_text(mill));
    write_ledger(folder.ledger(), {{"millwear", "hash", 1, "host"}, {}});
    LinerProfile liner = mill.liner;
    for (int cycle = 0; cycle < 3; ++cycle) {
      const wear::LinerRecord record = record_on(mill, liner);
      keep({cycle, StageKind::dem}, stage_files::load,
           [&](const auto& file) { wear::write_record(file, record); });
      if (cycle == 2) break;
      KeptCycle kept{0.0, 0.0, {}};
      for (const auto& step : evolved(liner, record.load)) {
        hours += step.duration / hour;
        liners.push_back({hours, step.profile});
        kept.steps.push_back({step.duration, step.removed_area, step.accounted_area,
                              step.fallen_area, step.profile});
      }
      keep({cycle, StageKind::wear}, stage_files::steps,
           [&](const auto& file) { write_cycle(file, kept); });
      liner = liners.back().profile;
    }
  }

  [[nodiscard]] std::vector<wear::GeometryStep> evolved(const LinerProfile& liner,
                                                        const WallLoad& load) const {
    return wear::evolve(
               std::vector<wear::TimedLoad>{
                   {0.0, liner,
                    wear::rate_of_load(mill.wear, mill.charge.classes, liner, load).smoothed.rate}},
               lifter_area(mill.liner), mill.campaign)
        .steps;
  }

  template <class Write>
  void keep(const StageId& stage, const char* name, const Write& write) {
    std::filesystem::create_directories(folder.stage(stage));
    const auto file = folder.stage(stage) / name;
    write(file);
    append_entry(folder.ledger(), {stage, Outcome::go_on, {{name, hash_of_file(file)}}, 1.0});
  }

  [[nodiscard]] Case case_with(std::vector<WearMechanism> mechanisms) const {
    Case other = mill;
    other.wear.mechanisms = std::move(mechanisms);
    return other;
  }

  /// Heights or profiles of the campaign's liners, after half its time.
  [[nodiscard]] std::vector<GaugeReading> heights() const {
    std::vector<GaugeReading> readings{{0.0, lifter_height(mill.liner), {}, {}, 1e-4}};
    for (std::size_t i = 1; i < liners.size(); i += 2)
      readings.push_back({0.5 * liners[i].hours, lifter_height(liners[i].profile), {}, {}, 1e-4});
    return readings;
  }
  [[nodiscard]] std::vector<GaugeReading> profiles() const {
    std::vector<GaugeReading> readings;
    for (std::size_t i = 2; i < liners.size(); i += 3)
      readings.push_back({0.5 * liners[i].hours, lifter_height(liners[i].profile),
                          plate_thickness(liners[i].profile), liners[i].profile, 1e-4});
    return readings;
  }

  [[nodiscard]] std::string refusal(const std::vector<GaugeReading>& readings,
                                    std::optional<double> until = {}) const {
    return failure_of<Failure>(
        [&] { static_cast<void>(calibrate(mill, folder, readings, until)); });
  }

  struct Liner {
    double hours;
    LinerProfile profile;
  };

  TemporaryFolder place;
  RunFolder folder{place.path()};
  Case mill = example_case();
  double hours = 0.0;
  std::vector<Liner> liners;
};

// The mill wore twice as fast as the campaign at 1e-12 1/Pa: k = 2e-12, whatever the case guesses.
TEST_F(CalibratedCampaign, GivesTheCoefficientOfAMillTwiceAsFast) {
  for (const double guess : {1e-12, 5e-11, 3e-14}) {
    const Case other = case_with({{WearLaw::archard, guess}});
    for (const auto& readings : {heights(), profiles()}) {
      const CalibratedLaw law = calibrate(other, folder, readings);
      const double found = law.calibrated.wear.mechanisms.at(0).specific_wear_rate;
      EXPECT_NEAR(found, 2e-12, 0.02 * 2e-12);
      EXPECT_NEAR(law.hours, 0.5 * hours, 0.02 * hours);
      EXPECT_NEAR(law.lifter_height, lifter_height(liners.back().profile), 1e-9);
      EXPECT_EQ(law.found.error_scale, 1.0);
      EXPECT_LT(law.elsewhere, 1e-7);
    }
  }
}

// Sliding alone wore it; impacts on one half are told apart by the profiles, and are none.
TEST_F(CalibratedCampaign, FindsNoneOfAMechanismThatTookNoPart) {
  const Case other = case_with({{WearLaw::archard, 1e-12}, {WearLaw::excess_energy, 1e-12}});
  const CalibratedLaw law = calibrate(other, folder, profiles());
  EXPECT_NEAR(law.found.fit.factors[0], 2.0, 0.05);
  EXPECT_LT(law.found.fit.factors[1], 0.05);
  EXPECT_TRUE(law.found.alike.empty());
  EXPECT_TRUE(law.by_section);
}

// A profile is fitted by its zones; its height and plate stand beside it.
TEST_F(CalibratedCampaign, ShowsEveryReadingBesideTheFitAndTheLine) {
  const CalibratedLaw law = calibrate(mill, folder, profiles());
  ASSERT_EQ(law.readings.size(), 3 * profiles().size());
  EXPECT_EQ(law.readings[0].quantity, MeasuredQuantity::worn_section);
  EXPECT_EQ(law.readings[0].use, ReadingUse::fitted);
  EXPECT_EQ(law.readings[1].quantity, MeasuredQuantity::lifter_height);
  EXPECT_EQ(law.readings[1].use, ReadingUse::shown);
  for (const auto& row : law.readings) {
    EXPECT_NEAR(row.fitted, row.measured, 5.0 * row.error);
    EXPECT_TRUE(std::isfinite(row.line) && std::isfinite(row.fitted_without));
  }
  EXPECT_EQ(law.found.freedom, 12 * static_cast<long>(profiles().size()) - 1);
}

// New at hour 0 is no reading; those later than --until are predicted from the others.
TEST_F(CalibratedCampaign, HoldsOutLaterReadings) {
  const auto readings = heights();
  const CalibratedLaw law = calibrate(mill, folder, readings, readings[2].operating_hours);
  ASSERT_EQ(law.readings.size(), readings.size() - 1);
  EXPECT_EQ(law.readings[1].use, ReadingUse::fitted);
  EXPECT_EQ(law.readings[2].use, ReadingUse::held_out);
  EXPECT_NEAR(law.readings[2].fitted, law.readings[2].measured, 5e-4);
  EXPECT_TRUE(std::isnan(law.readings[2].fitted_without));
  EXPECT_EQ(law.found.freedom, 1);
  ASSERT_EQ(law.rms.size(), 2U);
  EXPECT_EQ(law.rms[1].use, ReadingUse::held_out);
}

// One and a half errors behind the last liner are noise; ten are not reached.
TEST_F(CalibratedCampaign, LeavesOutWhatItDoesNotReach) {
  auto readings = heights();
  readings.push_back({hours, lifter_height(liners.back().profile) - 1e-3, {}, {}, 1e-4});
  readings[readings.size() - 2].lifter_height = lifter_height(liners.back().profile) - 1.5e-4;
  const CalibratedLaw law = calibrate(mill, folder, readings);
  EXPECT_EQ(law.readings[law.readings.size() - 2].use, ReadingUse::fitted);
  EXPECT_EQ(law.readings.back().use, ReadingUse::beyond_campaign);
  EXPECT_TRUE(std::isnan(law.readings.back().fitted));
  EXPECT_NEAR(law.found.fit.factors[0], 2.0, 0.1);
  EXPECT_THAT(refusal({readings.back()}),
              HasSubstr("more worn than the campaign's last liner (lifter"));
}

TEST_F(CalibratedCampaign, RefusesReadingsThatCannotDo) {
  EXPECT_THAT(refusal({}), HasSubstr("no reading is later than hour 0"));
  EXPECT_THAT(refusal({heights()[0]}), HasSubstr("no reading is later than hour 0"));
  EXPECT_THAT(refusal(heights(), 1e-3), HasSubstr("--until 0.001 h"));
  const Case two = case_with({{WearLaw::archard, 1e-12}, {WearLaw::corrosion, 0.0, 1e-12}});
  EXPECT_THAT(
      failure_of<InputError>([&] { static_cast<void>(calibrate(two, folder, {heights()[1]})); }),
      HasSubstr("1 measured values cannot give the coefficients of 2 mechanisms"));
}

TEST_F(CalibratedCampaign, RefusesACampaignThatHasWornNothing) {
  const TemporaryFolder other_place;
  folder = {other_place.path()};
  EXPECT_THAT(refusal(heights()), HasSubstr("no campaign is here"));
  put_text(folder.locked_case(), locked_case_text(mill));
  write_ledger(folder.ledger(), {{"millwear", "hash", 1, "host"}, {}});
  keep({0, StageKind::dem}, stage_files::load,
       [&](const auto& file) { wear::write_record(file, record_on(mill, mill.liner)); });
  EXPECT_THAT(refusal(heights()), HasSubstr("no wear of the campaign is done yet"));
}

// What is to be pasted: the coefficients to six digits, no other table.
TEST_F(CalibratedCampaign, WritesTheLinesForTheCase) {
  CalibratedLaw law = calibrate(mill, folder, profiles());
  const Case two = case_with({{WearLaw::archard, 1e-12, 0.0, 1}, {WearLaw::corrosion, 0.0, 1e-12}});
  law.calibrated.wear.mechanisms = two.wear.mechanisms;
  law.calibrated.wear.mechanisms[0].specific_wear_rate = 2e-12 / 3.0;
  EXPECT_THAT(wear_table(law),
              AllOf(testing::StartsWith("[wear]\n"), HasSubstr("bins = 120"),
                    HasSubstr("law = \"archard\""), HasSubstr("6.66667e-13"),
                    HasSubstr("material = \"ore\""), HasSubstr("depth_rate_m_per_year"),
                    testing::Not(HasSubstr("[campaign]"))));
}

TEST_F(CalibratedCampaign, IsAlsoATable) {
  const auto readings = heights();
  const std::string table =
      calibration_csv(calibrate(mill, folder, readings, readings[2].operating_hours));
  EXPECT_THAT(table,
              testing::StartsWith("# millwear calibration 1\noperating_hours,quantity,use,"));
  EXPECT_THAT(table, HasSubstr("lifter_height,held_out,"));
  EXPECT_THAT(table, HasSubstr(",,\n"));
}

}  // namespace
}  // namespace millwear::orchestrator
