#include "recorder/options/recording_plan.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "mill/base/failure.h"

namespace millwear::recorder {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> complete() {
  return {"--in",   "deck.in", "--case",  "case.toml", "--liner", "liner.csv",
          "--load", "load.h5", "--after", "100",       "--until", "300"};
}

std::vector<std::string> with(std::vector<std::string> words, const std::string& option,
                              const std::string& value) {
  const auto place = std::ranges::find(words, option);
  if (place != words.end())
    *(place + 1) = value;
  else
    words.insert(words.end(), {option, value});
  return words;
}

void expect_refused(const std::vector<std::string>& words, const std::string& why) {
  try {
    static_cast<void>(recording_plan(words));
    FAIL() << why;
  } catch (const Failure& problem) {
    EXPECT_EQ(problem.exit_code, ExitCode::usage);
    EXPECT_THAT(problem.what(), HasSubstr(why));
  }
}

/// The steps from `from` on that are sampled, up to the plan's end.
std::vector<long> sampled_steps(const RecordingPlan& plan, long from) {
  std::vector<long> steps;
  for (long step = from; step <= plan.last_step + 1; ++step)
    if (is_sampled(plan, step)) steps.push_back(step);
  return steps;
}

TEST(RecordingPlan, SamplesEveryStepUnlessTold) {
  const auto plan = recording_plan(complete());
  const auto steps = sampled_steps(plan, 0);
  EXPECT_EQ(steps.front(), 101);
  EXPECT_EQ(steps.back(), 300);
  EXPECT_EQ(steps.size(), 200u);
  EXPECT_EQ(samples_between(plan, 100, 300), 200);
}

// From step 100 to 300: every 30 steps behind the first, and the last.
TEST(RecordingPlan, SamplesStandForAllStepsOfTheMeasurement) {
  auto plan = recording_plan(with(complete(), "--every", "30"));
  EXPECT_THAT(sampled_steps(plan, 0), ElementsAre(130, 160, 190, 220, 250, 280, 300));
  EXPECT_EQ(samples_between(plan, 100, 300), 7);
  plan.last_step = 350;  // it goes on
  EXPECT_THAT(sampled_steps(plan, 301), ElementsAre(310, 340, 350));
  EXPECT_EQ(samples_between(plan, 300, 350), 3);
  EXPECT_THAT(sampled_steps(recording_plan(with(complete(), "--every", "301")), 0),
              ElementsAre(300));
}

TEST(RecordingPlan, RefusesWhatIsMissingUnknownOrNoNumber) {
  for (const std::size_t option : {0, 2, 4, 6, 8, 10}) {
    auto words = complete();
    const std::string name = words[option];
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(option),
                words.begin() + static_cast<std::ptrdiff_t>(option) + 2);
    expect_refused(words, name + " is required; see --help");
  }
  expect_refused(with(complete(), "--evry", "2"), "--evry");
  expect_refused(with(complete(), "--after", "soon"), "--after");
  expect_refused(with(complete(), "--after", "-1"), "--after");
  expect_refused(with(complete(), "--every", "0"), "--every");
}

TEST(RecordingPlan, RefusesStepsThatDoNotFit) {
  expect_refused(with(complete(), "--until", "100"), "--until 100 has to lie after --after 100");
  expect_refused(with(complete(), "--until", "50"), "--until 50 has to lie after --after 100");
  expect_refused(with(complete(), "--pairs-after", "99"), "--pairs-after 99 has to lie from");
  expect_refused(with(complete(), "--pairs-after", "300"), "before --until 300");
  EXPECT_EQ(recording_plan(with(complete(), "--pairs-after", "100")).pairs_after, 100);
}

std::vector<std::string> that_goes_on() {
  auto words = complete();
  words.insert(words.end(), {"--target-error", "0.05", "--go-on-by", "50", "--at-most", "500"});
  return words;
}

TEST(RecordingPlan, GoesOnOnlyIfTold) {
  EXPECT_FALSE(recording_plan(complete()).going_on);
  const auto plan = recording_plan(that_goes_on());
  ASSERT_TRUE(plan.going_on);
  EXPECT_EQ(plan.going_on->target_error, 0.05);
  EXPECT_EQ(plan.going_on->by_steps, 50);
  EXPECT_EQ(plan.going_on->at_most, 500);
  EXPECT_EQ(recording_plan(with(that_goes_on(), "--at-most", "300")).going_on->at_most, 300);
}

TEST(RecordingPlan, RefusesToGoOnByHalves) {
  for (const std::size_t option : {12, 14, 16}) {
    auto words = that_goes_on();
    words.erase(words.begin() + static_cast<std::ptrdiff_t>(option),
                words.begin() + static_cast<std::ptrdiff_t>(option) + 2);
    expect_refused(words, "--target-error, --go-on-by and --at-most belong together");
  }
  expect_refused(with(that_goes_on(), "--target-error", "0"), "--target-error");
  expect_refused(with(that_goes_on(), "--go-on-by", "-50"), "--go-on-by");
  expect_refused(with(that_goes_on(), "--at-most", "250"), "--at-most 250 has to be --until 300");
  expect_refused(with(that_goes_on(), "--at-most", "520"), "a multiple of --go-on-by 50");
}

}  // namespace
}  // namespace millwear::recorder
