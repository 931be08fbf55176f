#include "orchestrator/campaign/mesh_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mill/base/failure.h"
#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

TEST(CheckedLiner, OfTheExampleCanBeMeshed) {
  EXPECT_NO_THROW(check_liner_can_be_meshed(example_case()));
}

// A step of 0.1 mm on the lifter's top, which a tolerance of 1e-7 m keeps: over a slice of 0.2 m
// its facet takes 0.2 m tan 0.6 degrees / 0.1 mm = 21 layers, one more than the limit.
TEST(CheckedLiner, ThatCannotBeMeshedIsRefusedByName) {
  Case mill = example_case();
  auto& nodes = mill.liner.nodes;
  const auto top = nodes.begin() + static_cast<std::ptrdiff_t>(nodes.size() / 2);
  const Eigen::Vector2d foot(0.0, top->y());
  nodes.insert(top, {foot, foot + Eigen::Vector2d(0.0, 1e-4)});
  mill.dem.mesh_tolerance = 1e-5;
  try {
    check_liner_can_be_meshed(mill);
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("example.toml: the shortest facet"));
  }
}

}  // namespace
}  // namespace millwear::orchestrator
