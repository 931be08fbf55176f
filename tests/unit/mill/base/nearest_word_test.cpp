#include "mill/base/nearest_word.h"

#include <gtest/gtest.h>

namespace millwear {
namespace {

TEST(NearestWord, FindsSlipsOfThePen) {
  const std::vector<std::string_view> known = {"rows", "speed_rpm", "shell_diameter_m"};
  EXPECT_EQ(nearest_word("shell_diameter_mm", known), "shell_diameter_m");
  EXPECT_EQ(nearest_word("row", known), "rows");
  EXPECT_EQ(nearest_word("porosity", known), "");
}

}  // namespace
}  // namespace millwear
