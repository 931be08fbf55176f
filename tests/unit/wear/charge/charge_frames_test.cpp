#include "wear/charge/charge_frames.h"

#include <gmock/gmock.h>

namespace millwear::wear {
namespace {

using testing::ElementsAre;

TEST(FrameRange, GivesBackAValueToHalfAStep) {
  const FrameRange range{-4.0, 4.0};
  for (const double value : {-4.0, -1.234567, 0.0, 3.21, 4.0})
    EXPECT_NEAR(range.unpacked(range.packed(value)), value, 0.5 * 8.0 / 65535) << value;
  EXPECT_EQ(range.packed(-5.0), 0);
  EXPECT_EQ(range.packed(9.0), 65535);
}

TEST(FrameDifferences, AreThoseToTheRowBefore) {
  const std::vector<std::uint16_t> rows{10, 65535, 12, 1, 11, 65530};
  std::vector<std::uint16_t> packed = rows;
  to_differences(packed, 2);
  EXPECT_THAT(packed, ElementsAre(10, 65535, 2, 2, 65535, 65529));
  from_differences(packed, 2);
  EXPECT_EQ(packed, rows);
}

}  // namespace
}  // namespace millwear::wear
