#include "mill/load/mixing_record.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

constexpr MixingPlan plan{.piece = 100, .left_out = 200, .most = 1200, .revolution = 1600};

/// Steady after ten pieces, the first at which it can be.
MixingRecord steady() {
  MixingRecord record{plan, {{-3.0, 0.1}, {-200.0 / 3.0, 70.0}}};
  for (int i = 0; i < 8; ++i) record.pieces.push_back({-100.0 + 0.1 * i, 50.0});
  return record;
}

MixingRecord read_back(const std::string& text) {
  return mixing_from_csv(text, "mixing.csv", plan);
}

void expect_rejected(const std::string& text, const std::string& why) {
  try {
    static_cast<void>(read_back(text));
    FAIL() << why;
  } catch (const ResultRejected& problem) {
    EXPECT_THAT(problem.what(), HasSubstr("mixing.csv:"));
    EXPECT_THAT(problem.what(), HasSubstr(why));
  }
}

TEST(MixingRecord, ComesBackToTheLastBit) {
  const auto written = steady();
  const std::string text = mixing_csv(written);
  EXPECT_THAT(text, HasSubstr("\n200,0.125,-66.66666666666667,70,,,,,,,,drifts\n"));
  EXPECT_THAT(text, EndsWith(",steady\n"));
  const auto back = read_back(text);
  ASSERT_EQ(back.pieces.size(), 10U);
  EXPECT_EQ(back.pieces[1].torque, -200.0 / 3.0);
  EXPECT_EQ(back.steps(), 1000);
  EXPECT_EQ(back.revolutions(), 0.625);
  EXPECT_EQ(mixing_csv(back), text);
}

TEST(MixingRecord, RefusesWhatIsTornOrOfAnother) {
  const std::string text = mixing_csv(steady());
  const auto last = text.rfind('\n', text.size() - 2);
  expect_rejected(text.substr(0, last + 1), ":11: it ends at step 900, where");
  expect_rejected(text.substr(0, text.size() - 1), "is it torn?");
  expect_rejected(text.substr(0, last + 9), "");
  expect_rejected("", "not a `millwear mixing` of version 2");
  std::string newer = text;
  newer.replace(newer.find("mixing 2"), 8, "mixing 3");
  expect_rejected(newer, "not a `millwear mixing` of version 2");
  MixingPlan other = plan;
  other.piece = 50;
  EXPECT_THROW(static_cast<void>(mixing_from_csv(text, "mixing.csv", other)), ResultRejected);
}

TEST(MixingRecord, SaysHowItWent) {
  EXPECT_EQ(
      spoken_mixing(steady()),
      "mixed for 0.625 revolutions: torque drifts by 0.4 % (limit 5 %), kinetic energy by 0 % "
      "(limit 5 %)");
  MixingRecord drifting = steady();
  drifting.pieces = std::vector<MixedPiece>(12, {-100.0, 50.0});
  for (std::size_t i = 8; i < 12; ++i) drifting.pieces[i].torque = -150.0;
  EXPECT_EQ(spoken_mixing(drifting),
            "mixed for 0.75 revolutions, the most, and not steady: torque drifts by 40 % (limit 5 "
            "%), kinetic energy by 0 % (limit 5 %)");
}

TEST(MixingRecord, KeepsTheClassesOnTheLiner) {
  MixingRecord record = steady();
  for (auto& piece : record.pieces) piece.on_liner = {20.5, 10.0};
  const std::string text = mixing_csv(record);
  EXPECT_THAT(text, HasSubstr(",state,on_liner_1,on_liner_2\n"));
  EXPECT_THAT(text, EndsWith(",1,steady,20.5,10\n"));
  EXPECT_EQ(read_back(text).pieces, record.pieces);
  EXPECT_THAT(spoken_mixing(record), HasSubstr(", class 1 on the liner by 0 % (limit "));
}

// A charge of which nothing is known to drift or not leaves its fields empty.
TEST(MixingRecord, LeavesEmptyWhatIsNotKnown) {
  const MixingRecord still{plan, std::vector<MixedPiece>(12, {0.0, 50.0})};
  const std::string text = mixing_csv(still);
  EXPECT_THAT(text, EndsWith("\n1200,0.75,0,50,,,0,0.05,,,,at_most\n"));
  EXPECT_EQ(read_back(text).steps(), 1200);
}

}  // namespace
}  // namespace millwear
