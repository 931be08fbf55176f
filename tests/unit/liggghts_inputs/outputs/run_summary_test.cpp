#include "liggghts_inputs/outputs/run_summary.h"

#include <gtest/gtest.h>

#include <string>

namespace millwear::liggghts {
namespace {

/// What LIGGGHTS 3.8.0 prints of two runs, without its statistics of memory and neighbours.
const std::string log_of_two =
    "       0     1250   89.7   2.54   0\n"
    "Loop time of 0.283861 on 1 procs for 100 steps with 1250 atoms, finish time Sun Nov 22\n"
    "Neigh time (%) = 0.0568844 (20.0395)\n"
    "Ave neighs/atom = 3.0496\n"
    "Neighbor list builds = 8\n"
    "Dangerous builds = 0\n"
    "Loop time of 6.52737 on 2 procs for 2000 steps with 1250 atoms, finish time Sun Nov 22\n"
    "Neighbor list builds = 164\n"
    "Dangerous builds = 3\n"
    "millwear: stretch complete\n";

TEST(RunSummaries, TellEveryRun) {
  const auto runs = read_run_summaries(log_of_two);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].loop_seconds, 0.283861);
  EXPECT_EQ(runs[0].steps, 100);
  EXPECT_EQ(runs[0].neighbour_builds, 8);
  EXPECT_EQ(runs[0].dangerous_builds, 0);
  EXPECT_EQ(runs[1].loop_seconds, 6.52737);
  EXPECT_EQ(runs[1].steps, 2000);
  EXPECT_EQ(runs[1].neighbour_builds, 164);
  EXPECT_EQ(runs[1].dangerous_builds, 3);
}

TEST(RunSummaries, LeaveOutOneThatIsTorn) {
  const auto end_of_second = log_of_two.find("= 3\n") + 4;
  for (std::size_t length = 0; length < end_of_second; ++length)
    EXPECT_LT(read_run_summaries(log_of_two.substr(0, length)).size(), 2u) << length;
  EXPECT_EQ(read_run_summaries(log_of_two.substr(0, end_of_second)).size(), 2u);
}

TEST(RunSummaries, TakeNoNumberFromElsewhere) {
  EXPECT_TRUE(read_run_summaries("Neighbor list builds = 8\nDangerous builds = 0\n").empty());
  EXPECT_TRUE(read_run_summaries("Loop time of x on 1 procs for 100 steps\n"
                                 "Neighbor list builds = 8\nDangerous builds = 0\n")
                  .empty());
  EXPECT_TRUE(read_run_summaries("Loop time of 1 on 1 procs for 100 steps\n"
                                 "Dangerous builds = 0\n")
                  .empty());
}

}  // namespace
}  // namespace millwear::liggghts
