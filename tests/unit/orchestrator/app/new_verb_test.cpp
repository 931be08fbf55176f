#include "orchestrator/app/new_verb.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

class NewVerb : public testing::Test {
 protected:
  NewVerb() {
    options.common.case_file = folder.path() / "my_mill.toml";
    options.common.verbosity = Verbosity::quiet;
    options.drawing =
        std::filesystem::path(MILLWEAR_CASES).parent_path() / "examples/drawing/rail_lifter.dxf";
    options.shell_diameter = 1.0;
    options.rows = 12;
    options.plate_mm = 35.0;
    options.filling = 0.31;
    options.balls = "30:79,25:21";
  }
  [[nodiscard]] std::string refusal() const {
    try {
      new_verb(options);
    } catch (const Failure& problem) {
      return problem.what();
    }
    return "it was written";
  }

  TemporaryFolder folder;
  NewOptions options;
};

TEST_F(NewVerb, WritesACaseOfADrawing) {
  new_verb(options);
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  EXPECT_NEAR(lifter_height(mill.liner), 0.040, 1e-5);
  EXPECT_NEAR(mill.campaign.height_limit, 0.008, 1e-5);
  EXPECT_THAT(read_file(options.common.case_file), HasSubstr("rail_lifter.dxf\"  # given"));
}

TEST_F(NewVerb, NeverWritesOverAFile) {
  write_file(options.common.case_file, "mine");
  EXPECT_THAT(refusal(), HasSubstr("the file is there; delete it"));
  EXPECT_EQ(read_file(options.common.case_file), "mine");
}

TEST_F(NewVerb, WritesNothingWhereTheCaseIsRefused) {
  options.rows = 60;
  EXPECT_THAT(refusal(), HasSubstr("rail_lifter.dxf: the curve's ends are"));
  options.rows = 12;
  options.filling = 3.0;
  EXPECT_THAT(refusal(), HasSubstr("total_filling"));
  EXPECT_FALSE(std::filesystem::exists(options.common.case_file));
}

TEST_F(NewVerb, NamesOptionsThatContradict) {
  options.height_mm = 40.0;
  EXPECT_THAT(refusal(), HasSubstr("the drawing says the lifter's shape"));
  options.height_mm.reset();
  options.speed_rpm = 30.0;
  options.critical_fraction = 0.7;
  EXPECT_THAT(refusal(), HasSubstr("--speed-rpm and --critical"));
}

}  // namespace
}  // namespace millwear::orchestrator
