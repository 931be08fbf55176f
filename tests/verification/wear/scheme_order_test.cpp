#include <gtest/gtest.h>

#include <cstdio>

#include "tests/verification/wear/closed_form_campaign.h"

namespace millwear::wear {
namespace {

/// The runs of a scheme, printed with their order.
std::vector<ClosedFormRun> printed(const ClosedFormLoad& load, Scheme scheme) {
  const auto runs = refined(load, scheme);
  for (const auto& found : runs) {
    std::printf("%-8s %-9s %4d loads  error %.2e\n", load.name.c_str(), name_of(scheme).data(),
                found.loads, found.error);
  }
  std::printf("%-8s %-9s order %.2f\n", load.name.c_str(), name_of(scheme).data(), order_of(runs));
  return runs;
}

// An even rate on a ring leaves a ring. What is left is that the ring grows longer within a
// geometry step, whose section is that of its beginning.
TEST(SchemeOrder, EvenRateIsExact) {
  for (const Scheme scheme : {Scheme::threshold, Scheme::adaptive}) {
    const auto load = even_rate();
    for (const auto& found : refined(load, scheme)) EXPECT_LT(found.error, 5e-4);
  }
}

// The paper's scheme is of first order, the adaptive one of second, so that one per cent takes less
// than a third of the loads.
TEST(SchemeOrder, GrowingRate) {
  const auto load = growing_rate();
  const auto paper = printed(load, Scheme::threshold);
  const auto adaptive = printed(load, Scheme::adaptive);
  EXPECT_NEAR(order_of(paper), 1.0, 0.25);
  EXPECT_GT(order_of(adaptive), 1.7);
  const double fewer = loads_for(0.01, paper) / loads_for(0.01, adaptive);
  std::printf("growing: 1 %% takes %.0f loads by threshold, %.0f by adaptive, %.1f times fewer\n",
              loads_for(0.01, paper), loads_for(0.01, adaptive), fewer);
  EXPECT_GT(fewer, 3.0);
}

// The polyline's own error, 0.1 % and of the other sign, hides a little of the paper's scheme's.
TEST(SchemeOrder, RateBySlope) {
  const auto load = rate_by_slope();
  const auto paper = printed(load, Scheme::threshold);
  const auto adaptive = printed(load, Scheme::adaptive);
  EXPECT_NEAR(order_of(paper), 1.0, 0.5);
  EXPECT_GT(order_of(adaptive), 1.6);
  EXPECT_LT(adaptive.back().error, 2e-3);
}

}  // namespace
}  // namespace millwear::wear
