#include "orchestrator/export/charge_particles.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "orchestrator/vtk/vtp_file.h"
#include "tests/support/sample_frames.h"
#include "tests/support/vtp_reader.h"

namespace millwear::orchestrator {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;
using wear::sample_frames;

/// 16 bits over 2 m, and floats.
constexpr double places = 2.0 / 65535;

ReadVtp frame(std::size_t number, Rotation rotation = Rotation::as_new) {
  return read_vtp(vtp_file(charge_particles(sample_frames(), number, rotation)));
}

MATCHER_P(Within, tolerance, "") {
  return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= tolerance;
}

TEST(ChargeParticles, OfTheFirstFrameHaveTheWholeState) {
  const ReadVtp first = frame(0);
  EXPECT_THAT(first["Points/Points"],
              Pointwise(Within(1e-7), {-0.25, 0.1, -0.25, 0.4, 0.1, -0.25}));
  EXPECT_THAT(first["PointData/velocity_m_per_s"], ElementsAre(0, 0, 0, 1, 0, 2));
  EXPECT_THAT(first["PointData/spin_rad_per_s"], ElementsAre(1, 2, 3, 0, 0, 0));
}

TEST(ChargeParticles, OfALaterFrameHavePlaceAndSpeed) {
  const ReadVtp later = frame(1);
  EXPECT_THAT(later["Points/Points"],
              Pointwise(Within(places), {-0.25, 0.1, -0.25, 0.5, 0.1, -0.05}));
  EXPECT_THAT(later["PointData/speed_m_per_s"], Pointwise(Within(10.0 / 65535), {0.0, 2.0}));
  EXPECT_FALSE(later.arrays.contains("PointData/velocity_m_per_s"));
}

// Every second particle is kept, so they are numbers 1 and 3.
TEST(ChargeParticles, SayWhichTheyAre) {
  for (const std::size_t number : {0, 1}) {
    const ReadVtp read = frame(number);
    EXPECT_THAT(read["PointData/particle"], ElementsAre(1, 3));
    EXPECT_THAT(read["PointData/class"], ElementsAre(0, 1));
    EXPECT_THAT(read["PointData/diameter_m"],
                ElementsAre(DoubleNear(0.05, 1e-8), DoubleNear(0.03, 1e-8)));
    EXPECT_THAT(read["Verts/offsets"], ElementsAre(1, 2));
  }
}

// Mirrored in x: a velocity turns about with its x, a spin with its y and z.
TEST(ChargeParticles, OfAReversedMillAreTheMirrorImage) {
  const ReadVtp first = frame(0, Rotation::reversed);
  EXPECT_THAT(first["Points/Points"],
              Pointwise(Within(1e-7), {0.25, 0.1, -0.25, -0.4, 0.1, -0.25}));
  EXPECT_THAT(first["PointData/velocity_m_per_s"], ElementsAre(0, 0, 0, -1, 0, 2));
  EXPECT_THAT(first["PointData/spin_rad_per_s"], ElementsAre(1, -2, -3, 0, 0, 0));
  EXPECT_THAT(frame(1, Rotation::reversed)["Points/Points"],
              Pointwise(Within(places), {0.25, 0.1, -0.25, -0.5, 0.1, -0.05}));
}

TEST(ChargeParticles, AreOfAFrameThatThereIs) {
  EXPECT_THROW(static_cast<void>(charge_particles(sample_frames(), 2, Rotation::as_new)),
               std::logic_error);
}

}  // namespace
}  // namespace millwear::orchestrator
