#include "orchestrator/study/study_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "tests/needs_chromium/browser.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Three points of two replicates, of which the last has failed once.
class StudyPage : public testing::Test {
 protected:
  StudyPage() {
    Study study =
        study_of_case(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml", {"mill.rows=8,10,12"});
    study.name = "</script>spacing";
    study.replicates = 2;
    study.objective = objective_from("maximise life_hours");
    const StudyPlan plan = plan_of(study);
    std::vector<fs::path> folders;
    std::vector<StateOfCampaign> states;
    for (std::size_t i = 0; i < plan.campaigns.size(); ++i) {
      folders.push_back(folder.path() / std::to_string(i));
      keep(folders.back(), 1000.0 + 100.0 * static_cast<double>(i));
      states.push_back(
          {i + 1 < plan.campaigns.size() ? CampaignState::done : CampaignState::failed, ""});
    }
    for (const std::size_t reported : {0, 4}) put_text(folders[reported] / "report.html", "");
    page = drawn(study_html(study_results(plan, folders, states), installed_d3()),
                 folder.path() / "page");
  }

  static void keep(const fs::path& campaign, double life) {
    fs::create_directories(campaign / "results");
    put_text(campaign / "results" / "summary.json",
             fmt::format("{{\"life_reached\": true, \"life_hours\": {}, \"life_hours_low\": {}, "
                         "\"life_hours_high\": {}, \"life_tonnes\": null, \"cycles\": 0}}",
                         life, life - 20.0, life + 20.0));
    std::vector<HistoryRow> rows(3);
    std::vector<ProfileRow> profiles;
    for (int i = 0; i < 3; ++i) {
      const double hours = 0.5 * i * life;
      rows[i].operating_hours = hours;
      rows[i].lifter_height = 0.04 - 0.01 * i;
      rows[i].power = life / 10.0;
      profiles.push_back(
          {0, i, hours, {{-0.1, 0.0}, {0.0, 0.04 - 0.01 * i}, {0.1, 0.0}}, {0, 0, 0}});
    }
    put_text(campaign / "results" / "history.csv", history_csv(rows));
    put_text(campaign / "results" / "profiles.csv", profiles_csv(profiles));
  }

  const TemporaryFolder folder;
  std::string page;
};

TEST_F(StudyPage, NamesTheBestPointAndListsAll) {
  EXPECT_NE(page.find("Point 3 (rows 12) is the best"), std::string::npos);
  EXPECT_NE(page.find("5 of 6 done, 1 failed"), std::string::npos);
  EXPECT_EQ(count_of(part_between(page, "id=\"points-table\"", "</section>"), "<tr"), 4U);
  EXPECT_NE(page.find("points/0/report.html"), std::string::npos);
  EXPECT_EQ(page.find("points/2/report.html"), std::string::npos)
      << "a link to a report that is not there";
}

// Point 3 is the best; of point 2 no campaign has a report.
TEST_F(StudyPage, ShowsHowToCompareTheBestPoints) {
  EXPECT_NE(page.find("<code>millwear compare points/4 points/0</code>"), std::string::npos);
}

TEST_F(StudyPage, DrawsEffectsCoursesAndProfiles) {
  EXPECT_EQ(count_of(part_between(page, "id=\"effect-charts\"", "id=\"map\""), "<circle"), 3U);
  EXPECT_EQ(count_of(part_between(page, "id=\"height-chart\"", "</figure>"), "class=\"series"), 3U);
  EXPECT_EQ(count_of(part_between(page, "id=\"profile-charts\"", "</section>"), "class=\"profile"),
            9U);
  EXPECT_EQ(count_of(part_between(page, "id=\"difference-table\"", "</section>"), "<tr"), 3U);
}

TEST_F(StudyPage, ShowsANameAsTextWhateverItIs) {
  EXPECT_NE(page.find("<h1>&lt;/script&gt;spacing</h1>"), std::string::npos);
}

}  // namespace
}  // namespace millwear::orchestrator
