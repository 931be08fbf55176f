#include "orchestrator/report/deflate.h"

#include <gtest/gtest.h>

namespace millwear::orchestrator {
namespace {

// The first two bytes of RFC 1950 name the method and are a multiple of 31; the last four are the
// Adler-32 of the bytes, here of "abc": 1 + 97 + 98 + 99 = 295 and 98 + 196 + 295 = 589.
TEST(Deflate, WritesTheFormatOfZlib) {
  const auto packed = deflated(std::vector<std::uint8_t>{'a', 'b', 'c'});
  ASSERT_GT(packed.size(), 6U);
  EXPECT_EQ(packed[0] & 15, 8);
  EXPECT_EQ((256 * packed[0] + packed[1]) % 31, 0);
  EXPECT_EQ(256 * packed[packed.size() - 2] + packed[packed.size() - 1], 295);
  EXPECT_EQ(256 * packed[packed.size() - 4] + packed[packed.size() - 3], 589);
}

TEST(Deflate, MakesWhatRepeatsItselfShort) {
  EXPECT_LT(deflated(std::vector<std::uint8_t>(10000, 7)).size(), 50U);
}

}  // namespace
}  // namespace millwear::orchestrator
