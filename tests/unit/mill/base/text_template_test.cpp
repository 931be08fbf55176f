#include "mill/base/text_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace millwear {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(TextTemplate, PutsEveryValueInItsPlaces) {
  EXPECT_EQ(filled_template("run {{n}} # {{n}} of {{all}}\n", {{"n", "20"}, {"all", "40"}}),
            "run 20 # 20 of 40\n");
  EXPECT_EQ(filled_template("run 1", {}), "run 1");
}

TEST(TextTemplate, DoesNotFillWhatAValueHolds) {
  EXPECT_EQ(filled_template("{{a}}{{b}}", {{"a", "{{b}}"}, {"b", "1"}}), "{{b}}1");
}

TEST(TextTemplate, RefusesAPlaceholderWithoutValue) {
  EXPECT_THAT([] { static_cast<void>(filled_template("run {{n}}", {})); },
              ThrowsMessage<std::logic_error>(HasSubstr("no value for {{n}}")));
}

TEST(TextTemplate, RefusesAValueWithoutPlaceholder) {
  EXPECT_THAT(
      [] {
        static_cast<void>(filled_template("run 1", {{"n", "1"}}));
      },
      ThrowsMessage<std::logic_error>(HasSubstr("{{n}} is never used")));
}

TEST(TextTemplate, RefusesAPlaceholderThatIsNotClosed) {
  EXPECT_THAT(
      [] {
        static_cast<void>(filled_template("run {{n", {{"n", "1"}}));
      },
      ThrowsMessage<std::logic_error>(HasSubstr("never closed")));
}

}  // namespace
}  // namespace millwear
