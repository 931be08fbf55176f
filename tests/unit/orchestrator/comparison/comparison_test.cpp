#include "orchestrator/comparison/comparison.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/comparison/shown_cycles.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

Case pilot() { return read_case(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml"); }

TEST(SpreadCycles, KeepTheFirstAndTheLast) {
  EXPECT_THAT(spread({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 4), ElementsAre(0, 3, 6, 9));
  EXPECT_THAT(spread({2, 5}, 4), ElementsAre(2, 5));
  EXPECT_THAT(spread({}, 4), ElementsAre());
}

TEST(DifferingKeys, AreThoseThatNotAllCasesShare) {
  Case two = pilot();
  two.dem.seed = 7;
  Case three = pilot();
  three.feed_rate = 230.0 * 1000.0 / 3600.0;
  EXPECT_TRUE(differing_keys({pilot(), pilot()}).empty());
  const auto keys = differing_keys({pilot(), two, three});
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_EQ(keys[0].key, "[dem] `seed`");
  EXPECT_THAT(keys[0].values, ElementsAre("1", "7", "1"));
  EXPECT_EQ(keys[1].key, "[mill] `feed_rate_t_per_h`");
  EXPECT_THAT(keys[1].values, ElementsAre("none", "none", "230"));
}

TEST(DifferingKeys, CountThePointsOfAnOutline) {
  Case other = pilot();
  other.liner.nodes[6].y() += 0.01;
  const auto keys = differing_keys({pilot(), other});
  ASSERT_EQ(keys.size(), 1u);
  EXPECT_EQ(keys[0].values[0], std::to_string(other.liner.nodes.size()) + " points");
}

/// Folders of campaigns with the small files alone: the pilot mill's lifter, worn in two cycles.
class ComparedCampaigns : public testing::Test {
 protected:
  fs::path keep_start(const fs::path& name) const {
    const fs::path root = folder.path() / name;
    fs::create_directories(root);
    put_text(root / "case.lock.toml", locked_case_text(pilot()));
    write_ledger(root / "ledger.jsonl", {{"millwear", "hash", 2, "host"}, {}});
    return root;
  }

  fs::path keep_campaign(const fs::path& name, const std::string& reached) const {
    const fs::path root = keep_start(name);
    const Case mill = pilot();
    std::vector<HistoryRow> history;
    std::vector<ProfileRow> profiles;
    for (int cycle = 0; cycle < 2; ++cycle)
      for (int step = cycle == 0 ? 0 : 1; step < 2; ++step) {
        HistoryRow row{};
        row.cycle = cycle;
        row.step = step;
        row.operating_hours = 100.0 * (cycle + step);
        row.lifter_height = 0.04 - 0.01 * (cycle + step);
        row.worn_volume = 1e-3 * (cycle + step);
        row.power = 600.0;
        row.shoulder = 0.5;
        history.push_back(row);
        profiles.push_back({cycle, step, row.operating_hours, mill.liner.nodes,
                            std::vector<double>(mill.liner.nodes.size(), 0.0)});
      }
    put_text(root / "history.csv", history_csv(history));
    put_text(root / "profiles.csv", profiles_csv(profiles));
    put_text(root / "summary.json",
             R"({"life_reached": )" + reached +
                 R"(, "life_hours": 190, "life_hours_low": 150, "life_hours_high": 230,
                 "life_tonnes": null, "limit": "lifter height 18 mm"})");
    return root;
  }

  const TemporaryFolder folder;
};

// 12 lifters of steel of 7800 kg/m3 that lost 2e-3 m3/m each: 187.2 kg/m. 600 W on 0.12 m: 5 kW/m.
TEST_F(ComparedCampaigns, HaveTheirPublishedFigures) {
  const auto comparison = comparison_of(compared_campaigns(
      {keep_campaign("one", "true"), keep_campaign("two", "false"), keep_start("begun")}));
  EXPECT_THAT(comparison.differing, testing::IsEmpty());
  const auto json = nlohmann::json::parse(comparison_json(comparison));
  const auto& one = json["campaigns"][0];
  EXPECT_EQ(one["name"], "one");
  EXPECT_EQ(one["life_hours"], 190.0);
  EXPECT_EQ(one["life_hours_low"], 150.0);
  EXPECT_EQ(one["cycles"], 2.0);
  EXPECT_NEAR(one["worn_steel_kg_per_m"].get<double>(), 187.2, 1e-9);
  EXPECT_NEAR(one["power_w_per_m"].get<double>(), 5000.0, 1e-9);
  EXPECT_NEAR(one["shoulder_deg"].get<double>(), 28.6479, 1e-4);
  EXPECT_TRUE(one["tonnes"].is_null());
  EXPECT_THAT(one["missing"].dump(), HasSubstr("2 of 2 cycles have no dem/load.h5 here"));
  EXPECT_FALSE(json["campaigns"][1]["worn_out"].get<bool>());
  EXPECT_TRUE(json["campaigns"][2]["power_w_per_m"].is_null());
  EXPECT_THAT(json["campaigns"][2]["missing"].dump(), HasSubstr("no cycle is published yet"));
  const std::string text = comparison_text(comparison);
  EXPECT_THAT(text, testing::ContainsRegex("life \\[h\\] +190 +over 190 +over 0\n"));
  EXPECT_THAT(text, testing::ContainsRegex("power, first load \\[kW/m\\] +5.000 "));
}

// The new liner is that of cycle 0, after 100 h cycle 1 begins, after 200 h it is done.
TEST_F(ComparedCampaigns, ShowTheLinersThatTheirCyclesBeganWith) {
  const auto campaigns = compared_campaigns({keep_campaign("one", "true")});
  std::vector<double> hours;
  for (const auto& profile : campaigns.at(0).data.profiles)
    hours.push_back(profile.operating_hours);
  EXPECT_THAT(hours, ElementsAre(0.0, 100.0, 200.0));
}

TEST_F(ComparedCampaigns, OfOneNameTakeTheFolderAsItIsGiven) {
  const auto a = keep_start(fs::path("a") / "pilot");
  const auto b = keep_start(fs::path("b") / "pilot");
  const auto campaigns = compared_campaigns({a, b, keep_start("other")});
  EXPECT_EQ(campaigns.at(0).name, a.string());
  EXPECT_EQ(campaigns.at(1).name, b.string());
  EXPECT_EQ(campaigns.at(2).name, "other");
}

TEST_F(ComparedCampaigns, RefuseAFolderThatIsNone) {
  fs::create_directory(folder.path() / "empty");
  try {
    static_cast<void>(compared_campaigns({keep_start("begun"), folder.path() / "empty"}));
    FAIL();
  } catch (const InputError& problem) {
    EXPECT_THAT(problem.what(), HasSubstr("empty: no campaign is here"));
  }
}

}  // namespace
}  // namespace millwear::orchestrator
