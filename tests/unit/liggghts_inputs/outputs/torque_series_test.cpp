#include "liggghts_inputs/outputs/torque_series.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

using ::testing::StartsWith;
using ::testing::ThrowsMessage;

const std::string head = "# Time-averaged data for fix drive\n# TimeStep v_torque\n";

TEST(TorqueSeries, ReadsStepsAndTorques) {
  const auto series = read_torque_series(head + "100 -12.5\n200 -1.25e1\n300 0\n", "torque.txt");
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].step, 100);
  EXPECT_EQ(series[1].torque, -12.5);
  EXPECT_EQ(series[2].torque, 0.0);
}

TEST(TorqueSeries, RefusesATornOrBrokenLineByName) {
  for (const char* const line : {"300 -12.", "300 -12.5", "300", "300 \n", "\n", "300 nan\n",
                                 "300 inf\n", "x 1\n", "300 -12.5 4\n", "300 1x\n", "1.5 2\n"})
    EXPECT_THAT(
        [&] {
          static_cast<void>(read_torque_series(head + "100 1\n200 2\n" + line, "torque.txt"));
        },
        ThrowsMessage<ResultRejected>(StartsWith("torque.txt:5: ")))
        << line;
}

}  // namespace
}  // namespace millwear::liggghts
