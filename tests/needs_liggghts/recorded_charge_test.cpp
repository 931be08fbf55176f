#include <gtest/gtest.h>

#include <cmath>

#include "mill/case/time_step.h"
#include "tests/needs_liggghts/mill_trial.h"
#include "tests/needs_liggghts/sphere_trial.h"

namespace millwear::trial {
namespace {

using liggghts::StretchSteps;
using wear::ChargeFrames;
using wear::FieldSum;

class RecordedCharge : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

/// Of a frame's particle, without the particle's number where there is but one.
Eigen::Vector3d place(const ChargeFrames& frames, std::size_t frame, std::size_t particle = 0) {
  const std::size_t count = frames.particles();
  const auto value = [&](std::size_t axis) {
    return frames.places[(3 * frame + axis) * count + particle];
  };
  return {frames.across.unpacked(value(0)), frames.along.unpacked(value(1)),
          frames.across.unpacked(value(2))};
}

// 30 mm of steel in free flight: x = x0 + v t, z = z0 + w t - g t^2 / 2.
TEST_F(RecordedCharge, OfAThrownSphereHasTheFramesOfAParabola) {
  constexpr double dt = 5e-6;
  const Launch launch{{-0.05, 0.03, 0.0}, {0.5, 0.0, 1.0}, {0.0, 7.0, 0.0}};
  const auto recording = record_sphere(square_mill(), {dt, 0, 20000, 1}, launch);
  ASSERT_TRUE(recording.charge.frames);
  const ChargeFrames& frames = *recording.charge.frames;
  ASSERT_EQ(frames.particles(), 1U);
  ASSERT_EQ(frames.frames(), 12U);
  for (std::size_t i = 0; i < frames.frames(); ++i) {
    const double t = frames.times[i];
    EXPECT_NEAR(t, 1666 * dt * static_cast<double>(i + 1), 1e-12);
    const double vz = 1.0 - gravity * t;
    EXPECT_NEAR(place(frames, i).x(), -0.05 + 0.5 * t, 2e-5);
    EXPECT_NEAR(place(frames, i).y(), 0.03, 2e-5);
    EXPECT_NEAR(place(frames, i).z(), t - 0.5 * gravity * t * t, 2e-5);
    EXPECT_NEAR(frames.speed.unpacked(frames.speeds[i]), std::hypot(0.5, vz), 1e-4);
  }
  EXPECT_NEAR(frames.state[0], -0.05 + 0.5 * frames.times[0], 1e-6);
  EXPECT_NEAR(frames.state[3], 0.5, 1e-6);
  EXPECT_NEAR(frames.state[7], 7.0, 1e-5);
  EXPECT_EQ(frames.class_radius.at(frames.classes.at(0)), sphere_radius);
}

class RecordedMillCharge : public RecordedCharge {
 protected:
  void SetUp() override {
    RecordedCharge::SetUp();
    if (IsSkipped()) return;
    mix(mill_, {plan_.time_step, 4 * plan_.steps_per_pitch, 0, 20}, scratch_.stage("mix"), 1);
  }

  Case mill_ = small_mill(ContactPath::recorder);
  const StepPlan plan_ = plan_steps(mill_);
  const ScratchFolder scratch_;
};

TEST_F(RecordedMillCharge, HasAllOfTheMassAndTheDissipationOnAnyNumberOfRanks) {
  mill_.wear.time_blocks = 4;
  StretchSteps steps{plan_.time_step, 500, 800, 1};
  steps.pair_steps = 200;
  for (const int ranks : {1, 2}) {
    const auto folder = scratch_.stage("ranks_" + std::to_string(ranks));
    const auto recording = record(mill_, steps, mill_.liner, folder, "mix", ranks);
    const auto& fields = recording.charge.fields;
    const double mass = totals(mill_).mass;
    const auto sum = [&](FieldSum which) {
      return fields.sums.col(static_cast<Eigen::Index>(which)).sum();
    };
    EXPECT_EQ(fields.instants, 16.0);
    EXPECT_NEAR(sum(FieldSum::mass), 16.0 * mass, 1e-9 * mass);
    EXPECT_NEAR(fields.class_mass.sum(), 16.0 * mass, 1e-9 * mass);
    ASSERT_TRUE(recording.record.pairs);
    const auto& pairs = *recording.record.pairs;
    EXPECT_NEAR(fields.pair_duration, 200 * plan_.time_step, 1e-9);
    EXPECT_GT(pairs.normal_dissipation, 0.0);
    EXPECT_NEAR(fields.normal_dissipation.sum(), pairs.normal_dissipation,
                1e-9 * pairs.normal_dissipation);
    EXPECT_NEAR(fields.shear_dissipation.sum(), pairs.shear_dissipation,
                1e-9 * pairs.shear_dissipation);
  }
}

}  // namespace
}  // namespace millwear::trial
