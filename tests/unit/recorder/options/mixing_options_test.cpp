#include "recorder/options/mixing_options.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "mill/base/failure.h"

namespace millwear::recorder {
namespace {

using testing::HasSubstr;

std::vector<std::string> with(const std::string& option, const std::string& value) {
  std::vector<std::string> words = {"--in",      "deck.in", "--record",     "mixing.csv",
                                    "--piece",   "100",     "--after",      "400",
                                    "--at-most", "2400",    "--revolution", "1200"};
  const auto place = std::ranges::find(words, option);
  if (place != words.end()) *(place + 1) = value;
  return words;
}

void expect_refused(const std::vector<std::string>& words, const std::string& why) {
  try {
    static_cast<void>(mixing_options(words));
    FAIL() << why;
  } catch (const Failure& problem) {
    EXPECT_EQ(problem.exit_code, ExitCode::usage);
    EXPECT_THAT(problem.what(), HasSubstr(why));
  }
}

TEST(MixingOptions, AreThePlan) {
  const auto options = mixing_options(with("", ""));
  EXPECT_EQ(options.deck, "deck.in");
  EXPECT_EQ(options.record, "mixing.csv");
  EXPECT_EQ(options.plan.piece, 100);
  EXPECT_EQ(options.plan.left_out, 400);
  EXPECT_EQ(options.plan.most, 2400);
  EXPECT_EQ(options.plan.revolution, 1200);
}

TEST(MixingOptions, RefuseWhatIsMissingOrDoesNotFit) {
  for (const std::size_t option : {0, 2, 4, 6, 8, 10}) {
    auto words = with("", "");
    const std::string name = words[option];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(option),
                words.begin() + static_cast<std::ptrdiff_t>(option) + 2);
    expect_refused(words, name + " is required; see mix --help");
  }
  expect_refused(with("--piece", "0"), "--piece");
  expect_refused(with("--after", "450"), "--after 450 has to be a multiple of --piece 100");
  expect_refused(with("--at-most", "2450"), "--at-most 2450 has to be a multiple of --piece 100");
}

}  // namespace
}  // namespace millwear::recorder
