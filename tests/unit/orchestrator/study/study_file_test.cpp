#include "orchestrator/study/study_file.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class StudyFile : public testing::Test {
 protected:
  Study read(const std::string& text) const {
    put_text(folder.path() / "study.toml", head + text);
    return read_study(folder.path() / "study.toml");
  }
  std::string refusal(const std::string& text) const {
    return failure_of<InputError>([&] { static_cast<void>(read(text)); });
  }
  const std::string head = "format_version = 1\nname = \"s\"\ncase = \"case.toml\"\n";
  const TemporaryFolder folder;
};

TEST_F(StudyFile, HasAxesOfTheCaseAndDerivedOnes) {
  const Study study = read(
      "replicates = 3\nobjective = { maximise = \"life_hours / power_w\" }\n"
      "[[axes]]\nkey = \"mill.rows\"\nvalues = [8, 10]\n"
      "[[axes]]\nkey = \"spacing_to_height\"\nvalues = [2.5, 3.0]\nlabels = [\"near\", \"far\"]\n");
  EXPECT_EQ(study.case_file, folder.path() / "case.toml");
  EXPECT_EQ(study.replicates, 3);
  ASSERT_EQ(study.axes.size(), 2U);
  EXPECT_THAT(study.axes[0].labels, ElementsAre("8", "10"));
  EXPECT_THAT(study.axes[1].labels, ElementsAre("near", "far"));
  EXPECT_EQ(spoken(*study.objective), "maximise life_hours / power_w");
}

TEST_F(StudyFile, TakesSeedsAsReplicates) {
  const Study study = read("[[axes]]\nkey = \"dem.seed\"\nvalues = [4, 7]\n");
  EXPECT_TRUE(study.axes.empty());
  EXPECT_THAT(study.seeds, ElementsAre(4, 7));
  EXPECT_EQ(study.replicates, 2);
}

TEST_F(StudyFile, ReadsATableOfPoints) {
  put_text(folder.path() / "points.csv", "mill.rows,lifter.height_m\n8,0.03\n9,0.04\n");
  const Study study = read("table = \"points.csv\"\n");
  EXPECT_EQ(study.combine, Combine::table);
  EXPECT_THAT(study.axes.at(1).labels, ElementsAre("0.03", "0.04"));
}

TEST_F(StudyFile, TellsAllThatIsWrongWithItsLine) {
  EXPECT_THAT(refusal("replicats = 3\n[[axes]]\nkey = \"mill.rowz\"\nvalues = []\n"),
              AllOf(HasSubstr("study.toml:4: a study file has no key `replicats`; did you mean "
                              "`replicates`?"),
                    HasSubstr("study.toml:6: no case file has a key `mill.rowz`; did you mean"),
                    HasSubstr("study.toml:5: the axis `mill.rowz` has no `values`")));
}

TEST_F(StudyFile, RefusesTwoAxesOfOneKey) {
  const std::string axis = "[[axes]]\nkey = \"mill.rows\"\nvalues = [8]\n";
  EXPECT_THAT(refusal(axis + axis), HasSubstr("study.toml:7: two axes vary `mill.rows` (the other "
                                              "is on line 4)"));
}

TEST_F(StudyFile, RefusesAStudyThatVariesNothing) {
  EXPECT_THAT(refusal(""), HasSubstr("varies nothing"));
}

TEST_F(StudyFile, RefusesAValueTwice) {
  EXPECT_THAT(refusal("[[axes]]\nkey = \"mill.rows\"\nvalues = [8, 9, 8]\n"),
              HasSubstr("has the value 8 twice"));
}

TEST_F(StudyFile, RefusesAxesOfOtherLengthsToZip) {
  EXPECT_THAT(refusal("combine = \"zip\"\n[[axes]]\nkey = \"mill.rows\"\nvalues = [8, 9]\n"
                      "[[axes]]\nkey = \"lifter.height_m\"\nvalues = [0.03]\n"),
              HasSubstr("zip takes as many of each"));
}

TEST_F(StudyFile, ALatinHypercubeHasIntervalsAndSamples) {
  const Study study = read(
      "combine = \"latin_hypercube\"\nsamples = 4\n[[axes]]\nkey = \"mill.rows\"\nlow = 8\nhigh = "
      "16\n");
  EXPECT_EQ(study.axes.at(0).low, 8.0);
  EXPECT_THAT(refusal("combine = \"latin_hypercube\"\n[[axes]]\nkey = \"mill.rows\"\nlow = 8\n"),
              AllOf(HasSubstr("`low` < `high`"), HasSubstr("needs `samples`")));
}

TEST_F(StudyFile, ASearchHasABudgetAnObjectiveAndLimits) {
  const std::string axis = "[[axes]]\nkey = \"mill.rows\"\nlow = 8\nhigh = 16\n";
  const Study study = read(
      "combine = \"search\"\nbudget_points = 20\n"
      "objective = { maximise = \"life_hours\" }\n"
      "at_most = { power_w = 2e5 }\n" +
      axis);
  EXPECT_EQ(study.samples, 20);
  ASSERT_EQ(study.limits.size(), 1U);
  EXPECT_EQ(study.limits[0].result, "power_w");
  EXPECT_EQ(study.limits[0].value, 2e5);
  EXPECT_THAT(refusal("combine = \"search\"\n" + axis),
              AllOf(HasSubstr("needs `budget_points`"), HasSubstr("needs an `objective`")));
  EXPECT_THAT(
      refusal("at_least = { life_hours = 1 }\n[[axes]]\nkey = \"mill.rows\"\nvalues = [8]\n"),
      HasSubstr("are for `combine` = \"search\""));
}

TEST(StudyOfCase, TakesValuesAndRanges) {
  const Study study =
      study_of_case("case.toml", {"mill.rows=8,10", "lifter.height_m=0.03:0.05:0.01"});
  EXPECT_THAT(study.axes.at(0).labels, ElementsAre("8", "10"));
  EXPECT_THAT(study.axes.at(1).labels, ElementsAre("0.03", "0.04", "0.05"));
}

TEST(StudyOfCase, RefusesWhatIsNoAxis) {
  const auto refusal = [](const char* words) {
    return failure_of<InputError>([&] { static_cast<void>(study_of_case("c.toml", {words})); });
  };
  EXPECT_THAT(refusal("mill.rows"), HasSubstr("write KEY=VALUE,VALUE"));
  EXPECT_THAT(refusal("mill.rows=5:2:1"), HasSubstr("is no range"));
}

TEST(Objective, IsReadFromWords) {
  EXPECT_EQ(spoken(objective_from("minimise power_w")), "minimise power_w");
  EXPECT_THAT(failure_of<InputError>([] { static_cast<void>(objective_from("life_hours")); }),
              HasSubstr("write \"maximise COLUMN\""));
}

}  // namespace
}  // namespace millwear::orchestrator
