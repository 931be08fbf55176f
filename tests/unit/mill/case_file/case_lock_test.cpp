#include "mill/case_file/case_lock.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "mill/base/text_file.h"
#include "mill/case/case_units.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

/// Every number of the simulation is the same to the bit.
void expect_same(const Case& a, const Case& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.slice_length, b.slice_length);
  EXPECT_EQ(a.speed, b.speed);
  EXPECT_EQ(a.feed_rate, b.feed_rate);
  EXPECT_EQ(a.liner.sector.shell_radius, b.liner.sector.shell_radius);
  EXPECT_EQ(a.liner.sector.plate_radius, b.liner.sector.plate_radius);
  EXPECT_EQ(a.liner.sector.rows, b.liner.sector.rows);
  EXPECT_EQ(a.liner.nodes, b.liner.nodes);
  EXPECT_EQ(a.liner_material, b.liner_material);
  EXPECT_EQ(plan_steps(a).time_step, plan_steps(b).time_step);
  ASSERT_EQ(a.charge.classes.size(), b.charge.classes.size());
  for (std::size_t i = 0; i < a.charge.classes.size(); ++i) {
    EXPECT_EQ(a.charge.classes[i].material, b.charge.classes[i].material);
    EXPECT_EQ(a.charge.classes[i].diameter, b.charge.classes[i].diameter);
    EXPECT_EQ(a.charge.classes[i].count, b.charge.classes[i].count);
  }
  EXPECT_EQ(a.charge.declared.total, b.charge.declared.total);
  EXPECT_EQ(a.campaign.plate_limit, b.campaign.plate_limit);
  EXPECT_EQ(locked_case_text(a), locked_case_text(b));
}

Case read_back(const Case& mill) { return case_from_text(locked_case_text(mill), "lock.toml"); }

class LockedCase : public testing::TestWithParam<const char*> {};

TEST_P(LockedCase, SimulatesTheSame) {
  const Case mill = read_case(std::filesystem::path(MILLWEAR_CASES) / GetParam() / "case.toml");
  expect_same(mill, read_back(mill));
}

INSTANTIATE_TEST_SUITE_P(Shipped, LockedCase,
                         testing::Values("pilot_mill", "seed_mill_8m", "seed_mill_8m_full"));

TEST(LockedCase, KeepsEverySetting) {
  Case mill = example_case();
  mill.feed_rate = 230.0 / 3.6;
  mill.dem.longest_time_step = 1.7e-5;
  mill.dem.time_step = 1.1e-5;
  mill.dem.rolling_friction = RollingFriction::epsd2;
  mill.dem.skin = 0.0123;
  mill.dem.rank_split = RankSplit::axis;
  mill.dem.keep_dumps = true;
  mill.dem.seed = 4711;
  EXPECT_EQ(locked_case_text(mill).find("mix_until_steady"), std::string::npos);
  mill.dem.contact_path = ContactPath::recorder;
  mill.dem.mix_until_steady = true;
  const Case back = read_back(mill);
  EXPECT_EQ(locked_case_text(back), locked_case_text(mill));
  EXPECT_EQ(back.dem.time_step, mill.dem.time_step);
  EXPECT_EQ(back.dem.skin, mill.dem.skin);
  EXPECT_EQ(back.dem.rank_split, RankSplit::axis);
  EXPECT_EQ(back.dem.rolling_friction, RollingFriction::epsd2);
  EXPECT_TRUE(back.dem.keep_dumps);
  EXPECT_TRUE(back.dem.mix_until_steady);
  EXPECT_EQ(back.dem.seed, 4711U);
}

TEST(LockedCase, TellsOfATrialOfSkinsOnlyWhereThereIsOne) {
  Case mill = example_case();
  EXPECT_EQ(locked_case_text(mill).find("tune"), std::string::npos);
  mill.dem.tune = true;
  EXPECT_TRUE(read_back(mill).dem.tune);
}

TEST(LockedCase, KeepsEveryMechanism) {
  Case mill = example_case();
  mill.wear.mechanisms = {
      {WearLaw::archard, 1e-12, 0.0, std::size_t{0}, {}, 0.05},
      {WearLaw::finnie, 1.0 / 3.0e12, 0.0, {}, 0.02, 0.03},
      {WearLaw::corrosion, 0.0, depth_rate_from_m_per_year(1e-4)},
  };
  const auto back = read_back(mill).wear.mechanisms;
  ASSERT_EQ(back.size(), 3U);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].law, mill.wear.mechanisms[i].law);
    EXPECT_EQ(back[i].specific_wear_rate, mill.wear.mechanisms[i].specific_wear_rate);
    EXPECT_EQ(back[i].depth_rate, mill.wear.mechanisms[i].depth_rate);
    EXPECT_EQ(back[i].material, mill.wear.mechanisms[i].material);
    EXPECT_EQ(back[i].least_diameter, mill.wear.mechanisms[i].least_diameter);
    EXPECT_EQ(back[i].most_diameter, mill.wear.mechanisms[i].most_diameter);
  }
}

// One law for all is the same case, whichever of the two forms it was written in.
TEST(LockedCase, DoesNotTellTheTwoFormsOfOneLawApart) {
  Case mill = example_case();
  const std::string short_form = locked_case_text(mill);
  EXPECT_NE(short_form.find("law = \"archard\"\nspecific_wear_rate_per_pa = 1e-12\n"),
            std::string::npos);
  EXPECT_EQ(short_form.find("wear.mechanisms"), std::string::npos);
  mill.wear.mechanisms.front().material = 0;
  EXPECT_NE(locked_case_text(mill).find("[[wear.mechanisms]]"), std::string::npos);
}

// Speeds, feeds and depth rates are locked in the units of the file, and come back to the last bit.
RC_GTEST_PROP(LockedCase, UnitsRoundTripToTheBit, ()) {
  Case mill = example_case();
  mill.speed = *rc::gen::inRange(1, 100000) * 1e-4 * (std::numbers::pi / 30.0);
  mill.feed_rate = *rc::gen::inRange(1, 100000) * 1e-2 * (1000.0 / 3600.0);
  mill.wear.mechanisms.push_back(
      {WearLaw::corrosion, 0.0, depth_rate_from_m_per_year(*rc::gen::inRange(1, 100000) * 1e-7)});
  const Case back = read_back(mill);
  RC_ASSERT(back.wear.mechanisms.back().depth_rate == mill.wear.mechanisms.back().depth_rate);
  RC_ASSERT(back.speed == mill.speed);
  RC_ASSERT(back.feed_rate == mill.feed_rate);
}

// The most nodes a profile may have still fit the size limit of a case file.
TEST(LockedCase, OfTheFinestProfileStaysUnderTheSizeLimit) {
  Case mill = example_case();
  mill.liner.nodes.clear();
  for (int i = 0; i < 1000; ++i) {
    mill.liner.nodes.push_back(point_at(mill.liner.sector, 0.48 - 1e-3 * ((i % 333) * 0.0317),
                                        mill.liner.sector.pitch() * (i / 999.0 - 0.5)));
  }
  EXPECT_LT(locked_case_text(mill).size(), largest_input_file);
}

}  // namespace
}  // namespace millwear
