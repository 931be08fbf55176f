#include "orchestrator/study/study_results.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mill/base/failure.h"
#include "orchestrator/results/history.h"
#include "orchestrator/study/study_tables.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two points of two replicates each; lives of 1000 and 1020 h at the one, 1100 and 1140 h at the
/// other, each known to 10 h.
class StudyResult : public testing::Test {
 protected:
  StudyResult() {
    Study study =
        study_of_case(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml", {"mill.rows=10,12"});
    study.replicates = 2;
    study.objective = objective_from("maximise life_hours");
    plan = plan_of(study);
    const double lives[] = {1000.0, 1020.0, 1100.0, 1140.0};
    for (std::size_t i = 0; i < 4; ++i) {
      folders.push_back(folder.path() / std::to_string(i));
      keep(folders.back(), lives[i]);
      states.push_back({CampaignState::done, ""});
    }
  }

  static void keep(const fs::path& campaign, double life, bool is_worn_out = true) {
    fs::create_directories(campaign / "results");
    put_text(campaign / "results" / "summary.json",
             fmt::format("{{\"life_reached\": {}, \"life_hours\": {}, \"life_hours_low\": {}, "
                         "\"life_hours_high\": {}, \"life_tonnes\": 5000.0, \"cycles\": 0}}",
                         is_worn_out, life, life - 19.6, life + 19.6));
    std::vector<HistoryRow> rows(3);
    for (int i = 0; i < 3; ++i) {
      rows[i].cycle = i == 2 ? 1 : 0;
      rows[i].operating_hours = i * life / 2.0;
      rows[i].lifter_height = 0.04 - 0.01 * i;
      rows[i].power = i == 2 ? 300.0 : 100.0;
      rows[i].power_error = 10.0;
    }
    put_text(campaign / "results" / "history.csv", history_csv(rows));
  }

  [[nodiscard]] PointFigure figure(const StudyResults& results, std::size_t point,
                                   std::string_view name) const {
    const auto columns = figure_columns();
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == name) return results.points[point].figures[i];
    throw std::logic_error("no such figure");
  }

  const TemporaryFolder folder;
  StudyPlan plan;
  std::vector<fs::path> folders;
  std::vector<StateOfCampaign> states;
};

TEST_F(StudyResult, OfAPointIsTheMeanOfItsReplicates) {
  const auto results = study_results(plan, folders, states);
  const PointFigure life = figure(results, 0, "life_hours");
  EXPECT_NEAR(life.mean, 1010.0, 1e-9);
  EXPECT_NEAR(life.error, 10.0 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(life.scatter, 20.0 / std::sqrt(2.0), 1e-9);
}

TEST_F(StudyResult, HasNoLifeOfALinerThatIsNotWornOut) {
  EXPECT_EQ(figure(study_results(plan, folders, states), 0, "life_tonnes").mean, 5000.0);
  for (const auto& campaign : folders) keep(campaign, 1000.0, false);
  const auto results = study_results(plan, folders, states);
  EXPECT_TRUE(std::isnan(figure(results, 0, "life_hours").mean));
  EXPECT_TRUE(std::isnan(figure(results, 0, "life_tonnes").mean));
}

// Half the life at 100 W and half at 300 W, each load known to 10 W.
TEST_F(StudyResult, TakesThePowerOverTheLife) {
  const auto results = study_results(plan, folders, states);
  const PointFigure power = figure(results, 0, "power_w");
  EXPECT_NEAR(power.mean, 200.0, 1e-9);
  EXPECT_NEAR(power.error, 10.0 / std::sqrt(2.0) / std::sqrt(2.0), 1e-9);
}

// The means differ by 110 h and are known to 10 and 20 h by the scatter of their replicates: five
// standard errors.
TEST_F(StudyResult, SaysHowSurelyTheBestIsTheBest) {
  const auto results = study_results(plan, folders, states);
  EXPECT_EQ(results.best, 1U);
  EXPECT_GT(results.points[1].probability_of_best, 0.999);
}

TEST_F(StudyResult, ThatNoiseCannotTellApartIsTheBestByHalf) {
  for (std::size_t i = 0; i < 4; ++i) keep(folders[i], i % 2 == 0 ? 1000.0 : 1040.0);
  const auto results = study_results(plan, folders, states);
  EXPECT_NEAR(results.points[0].probability_of_best, 0.5, 0.02);
}

TEST_F(StudyResult, UsesTheReplicatesThatAreThere) {
  states[1] = {CampaignState::failed, ""};
  const auto results = study_results(plan, folders, states);
  EXPECT_EQ(results.points[0].done, 1);
  EXPECT_EQ(results.points[0].failed, 1);
  EXPECT_NEAR(figure(results, 0, "life_hours").mean, 1000.0, 1e-9);
  EXPECT_TRUE(std::isnan(figure(results, 0, "life_hours").scatter));
}

TEST_F(StudyResult, RefusesAnObjectiveThatIsNoColumn) {
  plan.study.objective = objective_from("maximise life_hour");
  EXPECT_THAT(
      failure_of<InputError>([&] { static_cast<void>(study_results(plan, folders, states)); }),
      HasSubstr("did you mean `life_hours`?"));
}

TEST_F(StudyResult, IsWrittenAsATableWithErrorAndScatter) {
  const auto results = study_results(plan, folders, states);
  const std::string csv = study_csv(results);
  EXPECT_THAT(csv, testing::StartsWith("# millwear study 2\npoint,mill.rows,replicates,done,failed,"
                                       "life_hours,life_hours_se,life_hours_scatter,"));
  EXPECT_THAT(csv, HasSubstr("\n2,12,2,2,0,1120,"));
}

TEST_F(StudyResult, IsWrittenAsJsonWithTheCampaignsOfEveryPoint) {
  const auto json = nlohmann::json::parse(study_json(study_results(plan, folders, states)));
  EXPECT_EQ(json["best"], 2);
  EXPECT_EQ(json["points"][0]["campaigns"].size(), 2U);
  EXPECT_EQ(json["points"][0]["campaigns"][1]["seed"], 2);
  EXPECT_EQ(json["points"][0]["values"]["mill.rows"], "10");
}

TEST_F(StudyResult, IsSpokenInATableForAReader) {
  EXPECT_THAT(study_text(study_results(plan, folders, states)), HasSubstr("1120.0 +- 7.1"));
}

}  // namespace
}  // namespace millwear::orchestrator
