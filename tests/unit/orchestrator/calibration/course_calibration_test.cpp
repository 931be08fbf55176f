#include "orchestrator/calibration/course_calibration.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/calibration/course_comparison.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

const std::filesystem::path cases = MILLWEAR_CASES;

/// A lifter of 215 mm on 99.5 mm of plate, with a limit of 30 mm.
Case mill() { return read_case(cases / "seed_mill_8m" / "case.toml"); }

/// A law that wears ever faster: height 215 - 0.1 T - 0.0001 T^2 [mm] and plate 99.5 - 0.05 T.
double height_at(double hours) { return 0.215 - 1e-4 * hours - 1e-7 * hours * hours; }
double plate_at(double hours) { return 0.0995 - 5e-5 * hours; }

HistoryRow row(int cycle, int step, double hours) {
  HistoryRow made{};
  made.cycle = cycle;
  made.step = step;
  made.operating_hours = hours;
  made.lifter_height = height_at(hours);
  made.plate_thickness = plate_at(hours);
  return made;
}

/// Two cycles of five steps of 100 h: the last liner is 15 mm high after 1000 h.
CampaignCourse campaign() {
  CampaignCourse course;
  for (int i = 0; i <= 10; ++i)
    course.history.push_back(row(i > 5 ? 1 : 0, i > 5 ? i - 5 : i, 100.0 * i));
  return course;
}

/// Replicates of the same campaign, each of which wears faster or slower by a share.
CampaignCourse campaign_with(const std::vector<double>& shares) {
  CampaignCourse course = campaign();
  const auto count = static_cast<Eigen::Index>(shares.size());
  for (const HistoryRow& own : course.history) {
    ReplicateRow replicate{own.cycle, own.step, own.operating_hours, Eigen::VectorXd(count),
                           Eigen::VectorXd(count)};
    for (Eigen::Index r = 0; r < count; ++r) {
      const double hours = own.operating_hours * (1.0 + shares[static_cast<std::size_t>(r)]);
      replicate.heights[r] = height_at(hours);
      replicate.plates[r] = plate_at(hours);
    }
    course.replicates.push_back(replicate);
  }
  return course;
}

GaugeReading height(double hours, double metres, double error = 1e-3) {
  return {hours, metres, {}, {}, error};
}

std::string refusal(const CampaignCourse& course, const std::vector<GaugeReading>& readings,
                    double until) {
  return failure_of<InputError>(
      [&] { static_cast<void>(calibrated_course(mill(), course, readings, {until})); });
}

// A mill that wears 0.4 times as fast: what the campaign has at 200, 500 and 900 h comes at 500,
// 1250 and 2250 h.
TEST(CalibratedCourse, FindsTheFactorOfAKnownLawAndPredictsWithIt) {
  const auto course =
      calibrated_course(mill(), campaign(),
                        {height(0.0, 0.215), height(500.0, height_at(200.0)),
                         height(1250.0, height_at(500.0)), height(2250.0, height_at(900.0))},
                        {500.0});
  EXPECT_NEAR(course.factor.value, 0.4, 1e-12);
  ASSERT_EQ(course.readings.size(), 4u);
  EXPECT_EQ(course.readings[0].use, CourseUse::fresh);
  EXPECT_EQ(course.readings[1].use, CourseUse::calibrated);
  EXPECT_EQ(course.readings[2].use, CourseUse::held_out);
  for (const auto& reading : course.readings)
    EXPECT_NEAR(reading.predicted.value, *reading.height, 1e-12);
  EXPECT_NEAR(course.readings[3].predicted_plate.value, plate_at(900.0), 1e-12);
  EXPECT_NEAR(course.rms, 0.0, 1e-12);
  EXPECT_EQ(course.held_out, 2);
  // The step from 900 to 1000 h goes from 44 to 15 mm: 30 mm come at 900 + 100 * 14 / 29 h.
  EXPECT_NEAR(course.life.value, (900.0 + 1400.0 / 29.0) / 0.4, 1e-6);
}

// Campaigns end within a micrometre of their limit.
TEST(CalibratedCourse, HasALifeWhereTheCampaignEndsJustAboveItsLimit) {
  CampaignCourse course = campaign();
  course.history.back().lifter_height = mill().campaign.height_limit + 0.9e-6;
  EXPECT_NEAR(calibrated_course(mill(), course, {height(200.0, 0.191)}, {200.0}).life.value, 1000.0,
              1e-6);
  course.history.back().lifter_height = mill().campaign.height_limit + 1.1e-6;
  EXPECT_TRUE(
      std::isnan(calibrated_course(mill(), course, {height(200.0, 0.191)}, {200.0}).life.value));
}

// Prediction 140 and 44 mm against read 142 and 40 mm: rms sqrt((4 + 16) / 2) = 3.16 mm. The line
// through 191 mm at 200 h falls 0.12 mm/h, to 155 and 107 mm: rms sqrt((169 + 4489) / 2) = 48.26
// mm.
TEST(CalibratedCourse, HoldsPredictionAndStraightLineAgainstWhatIsHeldOut) {
  const auto course = calibrated_course(
      mill(), campaign(), {height(200.0, 0.191), height(500.0, 0.142), height(900.0, 0.040)},
      {200.0});
  EXPECT_NEAR(course.factor.value, 1.0, 1e-12);
  EXPECT_NEAR(course.readings[2].line, 0.107, 1e-12);
  EXPECT_NEAR(course.rms, std::sqrt(10.0) * 1e-3, 1e-9);
  EXPECT_NEAR(course.line_rms, std::sqrt(2329.0) * 1e-3, 1e-9);
  EXPECT_THAT(course.verdict, HasSubstr("The prediction is better by 45.1 mm (93 %)"));
  EXPECT_NEAR(course.mape, 0.5 * (2.0 / 142.0 + 4.0 / 40.0), 1e-9);
  EXPECT_NEAR(course.line_mape, 0.5 * (13.0 / 142.0 + 67.0 / 40.0), 1e-9);
  EXPECT_THAT(course.verdict, HasSubstr("prediction 5.7 %, straight line 88.3 %"));
  EXPECT_NEAR(course.line_life, (215.0 - 30.0) / 0.12, 1e-9);
}

// Between 900 and 1000 h read heights leave the campaign at 15 mm.
TEST(CalibratedCourse, SaysNothingAfterTheLastLiner) {
  const auto course =
      calibrated_course(mill(), campaign(), {height(200.0, 0.191), height(1001.0, 0.014)}, {200.0});
  EXPECT_TRUE(std::isnan(course.readings[1].predicted.value));
  EXPECT_EQ(course.beyond, 1);
  EXPECT_EQ(course.held_out, 0);
  const std::string text = course_text(course);
  EXPECT_THAT(text, HasSubstr("1 reading is after the campaign's last liner"));
  EXPECT_THAT(text, HasSubstr("No height is held out and predicted"));
  EXPECT_THAT(course_csv(course), HasSubstr("\n1001,held out,0.014,0.001,,,,"));
}

// At 500 h the campaign is 140 mm high on 25 mm less plate: a gauge on the worn plate reads 165 mm.
TEST(CalibratedCourse, AddsThePlatesLossForAGaugeThatRestsOnIt) {
  const std::vector<GaugeReading> readings = {height(1000.0, 0.165), height(1800.0, 0.089)};
  const auto course = calibrated_course(mill(), campaign(), readings, {1000.0, GaugeOn::plate});
  EXPECT_NEAR(course.factor.value, 0.5, 1e-12);
  EXPECT_NEAR(course.readings[1].predicted.value, 0.044 + 0.045, 1e-12);
  EXPECT_TRUE(std::isnan(course.line_life));
  const auto from_new = calibrated_course(mill(), campaign(), readings, {1000.0});
  EXPECT_LT(from_new.factor.value, 0.4);
  // The life is to the height from the new plate in both.
  EXPECT_NEAR(course.life.value * 0.5, from_new.life.value * from_new.factor.value, 1e-9);
}

// Where the plate goes faster than the crest, a gauge on the plate never reads less.
TEST(CalibratedCourse, RefusesAHeightThatAGaugeOnThePlateNeverReads) {
  CampaignCourse course = campaign();
  for (HistoryRow& own : course.history)
    own.plate_thickness = 0.0995 - 1.1 * (0.215 - own.lifter_height);
  EXPECT_THAT(failure_of<InputError>([&] {
                static_cast<void>(calibrated_course(mill(), course, {height(500.0, 0.14)},
                                                    {500.0, GaugeOn::plate}));
              }),
              HasSubstr("--gauge-on"));
}

// Replicates that differ in pace alone are all the same once each is calibrated: with an exact
// reading no band is left (but for the chords of the steps), though uncalibrated they scatter.
TEST(CalibratedCourse, TakesTheNoiseOutThatTheReadingTellsOf) {
  const auto course = calibrated_course(
      mill(), campaign_with({-0.1, -0.05, 0.0, 0.05, 0.1}),
      {height(500.0, height_at(500.0), 1e-6), height(800.0, height_at(800.0))}, {500.0});
  const auto& later = course.readings[1].predicted;
  EXPECT_NEAR(later.band.low, later.value, 2e-3);
  EXPECT_NEAR(later.band.high, later.value, 2e-3);
  EXPECT_GT(height_at(720.0) - height_at(880.0), 40e-3);
  // A replicate 10 % faster takes a factor 10 % lower. Quantiles of five lie 10 % inside the ends.
  EXPECT_NEAR(course.factor.band.low, 1.0 / 1.095, 4e-3);
  EXPECT_NEAR(course.factor.band.high, 1.0 / 0.905, 4e-3);
}

// Replicates that are all the campaign itself: what is left is the error of the reading. 2 mm at
// 500 h, where 0.2 mm are lost an hour, are 10 h: 2 % of the factor, and at 800 h 16 h of 0.26
// mm/h.
TEST(CalibratedCourse, CarriesTheErrorOfTheReadingOn) {
  const auto course = calibrated_course(
      mill(), campaign_with(std::vector<double>(2000, 0.0)),
      {height(500.0, height_at(500.0), 2e-3), height(800.0, height_at(800.0))}, {500.0});
  const auto& later = course.readings[1].predicted.band;
  EXPECT_NEAR(course.factor.band.high - course.factor.band.low, 3.92 * 0.02, 0.005);
  EXPECT_NEAR(later.high - later.low, 3.92 * 16.0 * 0.26e-3, 1.5e-3);
  EXPECT_LT(later.low, height_at(800.0));
  EXPECT_GT(later.high, height_at(800.0));
  EXPECT_NEAR(course.life.band.high - course.life.band.low, 3.92 * 0.02 * course.life.value, 10.0);
}

// The same case gives the same band.
TEST(CalibratedCourse, DrawsTheSameErrorsEveryTime) {
  const auto band = [] {
    return calibrated_course(mill(), campaign_with(std::vector<double>(200, 0.0)),
                             {height(500.0, height_at(500.0))}, {500.0})
        .factor.band;
  };
  EXPECT_EQ(band().low, band().low);
  EXPECT_LT(band().low, band().high);
}

TEST(CalibratedCourse, HasNoBandsWithoutReplicatesAndSaysSo) {
  const auto course =
      calibrated_course(mill(), campaign(), {height(500.0, height_at(500.0))}, {500.0});
  EXPECT_TRUE(std::isnan(course.readings[0].predicted.band.low));
  EXPECT_TRUE(std::isnan(course.factor.band.low));
  EXPECT_THAT(course_text(course), HasSubstr("has no replicates.csv"));
  EXPECT_THAT(course_json(course), HasSubstr("\"low\": null"));
}

TEST(CalibratedCourse, RefusesWhatItCannotBeCalibratedOn) {
  EXPECT_THAT(refusal(campaign(), {height(0.0, 0.215), height(500.0, 0.14)}, 499.0),
              HasSubstr("the first is of 500 h"));
  EXPECT_THAT(refusal(campaign(), {{500.0, {}, 0.09, {}, 1e-3}}, 500.0),
              HasSubstr("bring in heights"));
  EXPECT_THAT(refusal(campaign(), {height(500.0, 0.014)}, 500.0),
              HasSubstr("deeper than the campaign's last liner (lifter 15.0 mm high)"));
  EXPECT_THAT(refusal(campaign(), {height(500.0, 0.216)}, 500.0), HasSubstr("show no wear"));
  EXPECT_THAT(refusal({{row(0, 0, 0.0)}, {}}, {height(500.0, 0.14)}, 500.0),
              HasSubstr("no geometry step yet"));
}

TEST(CalibratedCourse, RefusesReplicatesOfAnotherCampaign) {
  auto other = campaign_with({0.0, 0.1});
  other.replicates.pop_back();
  EXPECT_THROW(static_cast<void>(calibrated_course(mill(), other, {height(500.0, 0.14)}, {500.0})),
               ResultRejected);
}

TEST(CalibratedCourse, NotesThatHoursOfTheOperationAreDividedToo) {
  const auto text_with = [](const CampaignSettings& plan) {
    Case operated = mill();
    operated.campaign = plan;
    return course_text(calibrated_course(operated, campaign(), {height(500.0, 0.14)}, {500.0}));
  };
  const std::string note = "the operation changes at given hours";
  CampaignSettings plan = mill().campaign;
  EXPECT_THAT(text_with(plan), testing::Not(HasSubstr(note)));
  plan.operation = {{.from_height = 0.1, .speed = 2.0}, {.from_time = 1.0e6, .feed_rate = 3.0}};
  EXPECT_THAT(text_with(plan), testing::Not(HasSubstr(note)));
  plan.operation.push_back({.from_time = 2.0e6, .speed = 2.0});
  EXPECT_THAT(text_with(plan), HasSubstr(note));
  plan.operation.clear();
  plan.reversal_times = {1.0e6};
  EXPECT_THAT(text_with(plan), HasSubstr(note));
}

// The report has it where the case says how far to calibrate, and a warning where it cannot.
TEST(CalibratedCourse, IsForTheReportWhereTheCaseSaysHowFar) {
  CampaignResults data{};
  data.history = campaign().history;
  Case own = mill();
  own.gauge = {};
  add_calibrated_course(own, {height(500.0, 0.14)}, data);
  EXPECT_FALSE(data.calibrated);
  own.gauge.calibrate_until = 500.0;
  add_calibrated_course(own, {height(500.0, 0.14)}, data);
  EXPECT_TRUE(data.calibrated);
  data.calibrated.reset();
  add_calibrated_course(own, {height(500.0, 0.001)}, data);
  EXPECT_FALSE(data.calibrated);
  EXPECT_THAT(data.warnings, testing::ElementsAre(HasSubstr("calibrated prediction is left out")));
}

// Table 3 of the 2006 paper: a straight line through the first interval says 80, 58 and 37 mm
// where 84, 56 and 30 mm were read, off by 5.1 mm (rms).
TEST(SeedMill, ItsStraightLineIsOffByFiveMillimetres) {
  const Case seed = mill();
  const auto readings = needed_readings_in(cases / "seed_mill_8m_desktop" / "gauge", seed);
  CampaignCourse course;
  for (int i = 0; i <= 10; ++i) {
    course.history.push_back(row(0, i, 800.0 * i));
    course.history.back().lifter_height = 0.215 - 0.0205 * i;
  }
  const auto found = calibrated_course(seed, course, readings, {5112.0});
  ASSERT_EQ(found.readings.size(), 5u);
  EXPECT_NEAR(found.readings[1].line, 0.088, 1e-12);
  EXPECT_NEAR(found.readings[2].line, 0.080, 0.5e-3);
  EXPECT_NEAR(found.readings[3].line, 0.058, 0.5e-3);
  EXPECT_NEAR(found.readings[4].line, 0.037, 0.5e-3);
  EXPECT_NEAR(found.line_rms, 5.1e-3, 0.05e-3);
  // A campaign that wears evenly is that line.
  EXPECT_NEAR(found.rms, found.line_rms, 1e-9);
  EXPECT_THAT(found.verdict, HasSubstr("Neither is better."));
}

// The runs that are kept: their histories and replicates are real, and so is what comes of them.
// Nine readings are held out, three in each of three campaigns. A band of 95 % may leave one of
// them.
TEST(SeedMill, KeptCampaignsHaveTheReadingsInTheirBands) {
  const auto folder = cases / "seed_mill_8m_desktop";
  const Case seed = read_case(folder / "case.toml");
  const auto readings = needed_readings_in(folder / "gauge", seed);
  int kept = 0;
  int outside = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "reference")) {
    SCOPED_TRACE(entry.path().filename());
    const auto found = calibrated_course(seed,
                                         {read_history_csv(entry.path() / "history.csv"),
                                          read_replicates_csv(entry.path() / "replicates.csv")},
                                         readings, {*seed.gauge.calibrate_until});
    ++kept;
    EXPECT_EQ(found.held_out, 3);
    EXPECT_NEAR(found.factor.value, 1.9, 0.2);
    for (const auto& reading : found.readings) {
      const double own = 2.0 * reading.error;
      outside += reading.predicted.band.low > *reading.height + own ||
                 reading.predicted.band.high < *reading.height - own;
    }
    EXPECT_TRUE(std::isfinite(found.life.value));
  }
  EXPECT_EQ(kept, 3);
  EXPECT_LE(outside, 1);
}

}  // namespace
}  // namespace millwear::orchestrator
