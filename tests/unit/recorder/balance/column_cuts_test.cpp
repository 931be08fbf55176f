#include "recorder/balance/column_cuts.h"

#include <gmock/gmock.h>

namespace millwear::recorder {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

TEST(ColumnCuts, GiveEveryColumnAsMany) {
  const std::vector<double> counts = {0.0, 6.0, 2.0, 0.0};
  EXPECT_THAT(column_cuts(counts, 2, 0.01),
              Pointwise(DoubleNear(1e-12), {0.0, 0.25 + 0.25 * 4.0 / 6.0, 1.0}));
}

TEST(ColumnCuts, OfAnEvenChargeAreEven) {
  const std::vector<double> counts(64, 3.0);
  EXPECT_THAT(column_cuts(counts, 4, 0.01),
              Pointwise(DoubleNear(1e-12), {0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(ColumnCuts, LeaveEveryColumnItsWidth) {
  std::vector<double> counts(100, 0.0);
  counts[99] = 1000.0;
  EXPECT_THAT(column_cuts(counts, 3, 0.1), Pointwise(DoubleNear(1e-12), {0.0, 0.8, 0.9, 1.0}));
  counts[99] = 0.0;
  counts[0] = 1000.0;
  EXPECT_THAT(column_cuts(counts, 3, 0.1), Pointwise(DoubleNear(1e-12), {0.0, 0.1, 0.2, 1.0}));
}

TEST(ColumnCuts, AreEvenWithoutParticlesOrRoom) {
  EXPECT_THAT(column_cuts(std::vector<double>(8, 0.0), 2, 0.1), ElementsAre(0.0, 0.5, 1.0));
  EXPECT_THAT(column_cuts(std::vector<double>(8, 1.0), 4, 0.6),
              Pointwise(DoubleNear(1e-12), {0.0, 0.25, 0.5, 0.75, 1.0}));
}

TEST(ColumnCuts, OfOneColumnAreTheEnds) {
  EXPECT_THAT(column_cuts(std::vector<double>(8, 1.0), 1, 0.1), ElementsAre(0.0, 1.0));
}

}  // namespace
}  // namespace millwear::recorder
