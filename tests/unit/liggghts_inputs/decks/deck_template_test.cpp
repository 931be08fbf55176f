#include "liggghts_inputs/decks/deck_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace millwear::liggghts {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(DeckTemplate, PutsEveryValueInItsPlaces) {
  EXPECT_EQ(filled_template("run {{n}} # {{n}} of {{all}}\n", {{"n", "20"}, {"all", "40"}}),
            "run 20 # 20 of 40\n");
  EXPECT_EQ(filled_template("run 1", {}), "run 1");
}

TEST(DeckTemplate, DoesNotFillWhatAValueHolds) {
  EXPECT_EQ(filled_template("{{a}}{{b}}", {{"a", "{{b}}"}, {"b", "1"}}), "{{b}}1");
}

TEST(DeckTemplate, RefusesAPlaceholderWithoutValue) {
  EXPECT_THAT([] { static_cast<void>(filled_template("run {{n}}", {})); },
              ThrowsMessage<std::logic_error>(HasSubstr("no value for {{n}}")));
}

TEST(DeckTemplate, RefusesAValueWithoutPlaceholder) {
  EXPECT_THAT(
      [] {
        static_cast<void>(filled_template("run 1", {{"n", "1"}}));
      },
      ThrowsMessage<std::logic_error>(HasSubstr("{{n}} is never used")));
}

TEST(DeckTemplate, RefusesAPlaceholderThatIsNotClosed) {
  EXPECT_THAT(
      [] {
        static_cast<void>(filled_template("run {{n", {{"n", "1"}}));
      },
      ThrowsMessage<std::logic_error>(HasSubstr("never closed")));
}

}  // namespace
}  // namespace millwear::liggghts
