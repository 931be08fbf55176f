#include "orchestrator/pictures/tachyon.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

/// 2 m high and wide, seen along +y, with one red ball at its upper right.
Scene one_ball() {
  return {{Projection::orthographic, {0, -5, 0}, {0, 1, 0}, {0, 0, 1}, 2.0},
          {0.0, 1.0, 0.0},
          {{{0.5, 0.0, 0.5}, 0.25, {1.0, 0.0, 0.0}}},
          {}};
}

Rgb pixel(const Image& image, int x, int y) {
  const auto at = 3 * static_cast<std::size_t>(y * image.size.width + x);
  const auto colour = [&](std::size_t i) {
    return static_cast<unsigned char>(image.pixels[at + i]) / 255.0;
  };
  return {colour(0), colour(1), colour(2)};
}

TEST(Tachyon, DrawsXToTheRightAndZUpToScale) {
  const Image image = rendered(one_ball(), {80, 80});
  ASSERT_EQ(image.size.width, 80);
  const Rgb ball = pixel(image, 60, 20);
  EXPECT_GT(ball[0], 0.4);
  EXPECT_LT(ball[1], 0.3);
  const Rgb white = Rgb::Ones();
  for (const auto& [x, y] : {std::pair{20, 20}, {60, 60}, {20, 60}, {40, 20}, {60, 32}, {72, 20}})
    EXPECT_EQ(pixel(image, x, y), white) << x << ", " << y;
  EXPECT_NE(pixel(image, 60, 28), white) << "the radius is ten pixels";
}

// A triangle between the eye and the ball.
TEST(Tachyon, WhatIsNearerHidesWhatIsBehind) {
  Scene scene = one_ball();
  scene.triangles.push_back(
      {{{0.0, -1.0, 0.0}, {1.0, -1.0, 0.0}, {1.0, -1.0, 1.0}}, {0.0, 0.0, 1.0}});
  const Rgb seen = pixel(rendered(scene, {80, 80}), 62, 22);
  EXPECT_GT(seen[2], seen[0]);
}

TEST(Tachyon, ASceneIsWrittenWithOneTextureAColourAndXMirrored) {
  Scene scene = one_ball();
  scene.spheres.push_back(scene.spheres[0]);
  const std::string text = tachyon_scene(scene, {80, 80});
  EXPECT_THAT(text, HasSubstr("SPHERE CENTER -0.5 0 0.5 RAD 0.25 c0"));
  EXPECT_EQ(text.find("TEXDEF c0"), text.rfind("TEXDEF"));
  EXPECT_THAT(text, HasSubstr("ZOOM 0.5\n"));
}

TEST(Tachyon, MissingSaysWhichPackageHasIt) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  EXPECT_THAT(
      [] {
        static_cast<void>(rendered(one_ball(), {8, 8}));
      },
      testing::ThrowsMessage<ExternalProgramError>(HasSubstr("tachyon-bin-nox")));
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace millwear::orchestrator
