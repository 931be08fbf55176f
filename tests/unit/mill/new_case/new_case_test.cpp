#include "mill/new_case/new_case.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

NewCase ball_mill() {
  return {"my_mill", 1.0, 12, {}, {}, {}, 0.31, {}, size_shares("30:60,25:40"), {}};
}

TEST(SizeShares, AreMillimetresAndPercent) {
  const auto sizes = size_shares("90:39.9,63:60.1");
  ASSERT_EQ(sizes.size(), 2U);
  EXPECT_DOUBLE_EQ(sizes[0].diameter, 0.090);
  EXPECT_EQ(sizes[1].percent, 60.1);
  EXPECT_EQ(size_shares("100").at(0).percent, 100.0);
  EXPECT_THAT([] { static_cast<void>(size_shares("90:x")); },
              ThrowsMessage<InputError>(HasSubstr("has `x` where a number above 0 belongs")));
  EXPECT_THAT([] { static_cast<void>(size_shares("")); },
              ThrowsMessage<InputError>(HasSubstr("where a number above 0 belongs")));
  EXPECT_THAT([] { static_cast<void>(size_shares("63:1,90:1")); },
              ThrowsMessage<InputError>(HasSubstr("does not begin with the largest")));
}

TEST(NewCase, IsACaseThatRuns) {
  const Case mill = case_from_text(new_case_text(ball_mill()), "my_mill.toml");
  EXPECT_EQ(mill.name, "my_mill");
  EXPECT_EQ(mill.liner.sector.rows, 12);
  EXPECT_NEAR(filling_inside_plate(mill), 0.31, 3e-3);
  EXPECT_NEAR(critical_speed_fraction(mill), 0.75, 1e-9);
  EXPECT_NEAR(lifter_height(mill.liner), 0.025, 1e-9);
  EXPECT_EQ(mill.charge.classes.size(), 2U);
}

TEST(NewCase, TakesWhatIsGiven) {
  NewCase wanted = ball_mill();
  wanted.speed_rpm = 31.0;
  wanted.liner.height = 0.04;
  wanted.liner.top_width = 0.05;
  wanted.liner.face_angle = 20.0;
  wanted.liner.plate_thickness = 0.035;
  wanted.ore = size_shares("40:100");
  wanted.ball_filling = 0.1;
  const Case mill = case_from_text(new_case_text(wanted), "my_mill.toml");
  EXPECT_NEAR(mill.speed, 31.0 * 0.10471975511965977, 1e-12);
  EXPECT_NEAR(lifter_height(mill.liner), 0.04, 1e-12);
  EXPECT_NEAR(plate_thickness(mill.liner), 0.035, 1e-12);
  EXPECT_EQ(mill.materials.size(), 2U);
  EXPECT_EQ(mill.pairs.size(), 3U);
}

// Every value says where it comes from.
TEST(NewCase, HasACommentOnEveryNumber) {
  const std::string text = new_case_text(ball_mill());
  std::size_t values = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = text.find('\n', from);
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    const bool has_value = line.find(" = ") != std::string::npos &&
                           line.find_first_of("0123456789") != std::string::npos &&
                           line.find("format_version") == std::string::npos;
    if (!has_value) continue;
    ++values;
    EXPECT_THAT(line, HasSubstr(" # "));
  }
  EXPECT_GT(values, 20U);
}

TEST(NewCase, AsksForWhatItCannotDerive) {
  NewCase wanted = ball_mill();
  wanted.ore = size_shares("40");
  EXPECT_THAT([&] { static_cast<void>(new_case_text(wanted)); },
              ThrowsMessage<InputError>(HasSubstr("--ball-filling")));
  wanted.ore.clear();
  wanted.balls.clear();
  EXPECT_THAT([&] { static_cast<void>(new_case_text(wanted)); },
              ThrowsMessage<InputError>(HasSubstr("the charge is not given")));
}

}  // namespace
}  // namespace millwear
