#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

// The paper's table as printed: 26,765 particles, all of them there after 200 steps.
TEST(SeedMill, KeepsItsParticlesFor200Steps) {
  if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  const Case mill = read_case(MILLWEAR_CASES "/seed_mill_8m/case.toml");
  const ScratchFolder scratch;
  const auto start = std::chrono::steady_clock::now();
  const auto stretch = mix(mill, {plan_steps(mill).time_step, 200, 0, 20}, scratch.stage("mix"), 2);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", fmt::format("{:.1f}", taken.count()));
  ASSERT_FALSE(stretch.log.thermo.empty());
  EXPECT_EQ(stretch.log.thermo.back().step, 200);
  for (const auto& line : stretch.log.thermo) EXPECT_EQ(line.atoms, 26765u);
  EXPECT_EQ(stretch.log.triangles, stretch.mesh.triangles.size());
  EXPECT_LT(taken.count(), 60.0);
}

}  // namespace
}  // namespace millwear::trial
