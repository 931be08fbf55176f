#include "liggghts_inputs/outputs/dump_columns.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Names = std::vector<std::string_view>;

// pos id force_normal force_tangential are columns 1-6, 7-9, 10-12 and 13-15.
TEST(DumpColumns, FindsThoseOfWallContactsInAnyOrder) {
  const Names names = {"c_w[9]",  "c_w[8]",  "c_w[7]",  "c_w[3]",  "c_w[2]",  "c_w[1]",
                       "c_w[15]", "c_w[14]", "c_w[13]", "c_w[12]", "c_w[11]", "c_w[10]"};
  const auto chosen = choose_contact_columns(usual_contact_keywords)(names);
  EXPECT_EQ(chosen.problem, "");
  EXPECT_THAT(chosen.columns, ElementsAre(5, 4, 3, 1, 0, 11, 10, 9, 8, 7, 6));
}

// With vel, which LIGGGHTS prints behind pos wherever the word stands, all behind it moves by six.
TEST(DumpColumns, NumbersThemByTheKeywordsOfTheCompute) {
  const Names names = {"c_w[1]",  "c_w[2]",  "c_w[3]",  "c_w[14]", "c_w[15]", "c_w[16]",
                       "c_w[17]", "c_w[18]", "c_w[19]", "c_w[20]", "c_w[21]"};
  const auto chosen =
      choose_contact_columns("force_tangential force_normal pos id vel delta")(names);
  EXPECT_EQ(chosen.problem, "");
  EXPECT_THAT(chosen.columns, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
}

TEST(DumpColumns, NamesAColumnThatIsMissing) {
  const Names names = {"c_w[1]", "c_w[2]", "c_w[3]", "c_w[9]", "c_w[10]"};
  EXPECT_THAT(choose_contact_columns(usual_contact_keywords)(names).problem,
              HasSubstr("no column c_w[8], the triangle"));
  const Names spins = {"id", "type", "x", "y", "z"};
  EXPECT_THAT(choose_spin_columns()(spins).problem, HasSubstr("no column radius"));
}

TEST(DumpColumns, RefusesColumnsOfNoComputeAndOfTwo) {
  const auto choose = choose_contact_columns(usual_contact_keywords);
  EXPECT_THAT(choose(Names{"x", "y"}).problem, HasSubstr("not \"x y\""));
  EXPECT_THAT(choose(Names{"c_a[1]", "c_b[1]"}).problem, HasSubstr("one compute"));
}

TEST(DumpColumns, RefusesKeywordsThatDoNotDo) {
  EXPECT_THAT([] { static_cast<void>(choose_contact_columns("pos idd")); },
              ThrowsMessage<InputError>(HasSubstr("no keyword \"idd\"")));
  EXPECT_THAT([] { static_cast<void>(choose_contact_columns("pos id force")); },
              ThrowsMessage<InputError>(HasSubstr("without force_normal")));
}

TEST(DumpColumns, FindsThoseOfParticles) {
  const Names names = {"omegax", "omegay", "omegaz", "id", "mass", "type", "radius",
                       "x",      "y",      "z",      "vx", "vy",   "vz"};
  EXPECT_THAT(choose_spin_columns()(names).columns,
              ElementsAre(3, 5, 6, 7, 8, 9, 10, 11, 12, 0, 1, 2));
}

}  // namespace
}  // namespace millwear::liggghts
