#include "orchestrator/pictures/image.h"

#include <gtest/gtest.h>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using namespace std::string_literals;

TEST(Image, IsReadFromAPpm) {
  const Image image = image_from_ppm("P6\n2 1\n255\nabcdef");
  EXPECT_EQ(image.size.width, 2);
  EXPECT_EQ(image.size.height, 1);
  EXPECT_EQ(image.pixels, "abcdef");
}

TEST(Image, OfAnythingElseIsRefused) {
  for (const auto& bytes : {""s, "P5\n2 1\n255\nabcdef"s, "P6\n2 1\n65535\nabcdef"s,
                            "P6\n2 1\n255\nabcde"s, "P6\n2 1\n255\nabcdefg"s})
    EXPECT_THROW(static_cast<void>(image_from_ppm(bytes)), ExternalProgramError) << bytes;
}

// Two by two pixels of 10, 20, 30 and 40 make one of 25; the third column is left over.
TEST(Image, ShrinksToTheMeanOfItsPixels) {
  const std::string pixels =
      "\x0a\x0a\x0a\x14\x14\x14\xff\xff\xff\x1e\x1e\x1e\x28\x28\x28\xff\xff\xff"s;
  const Image small = shrunk({{3, 2}, pixels}, 2);
  EXPECT_EQ(small.size.width, 1);
  EXPECT_EQ(small.size.height, 1);
  EXPECT_EQ(small.pixels, "\x19\x19\x19"s);
}

}  // namespace
}  // namespace millwear::orchestrator
