#include "orchestrator/pictures/liner_drawing.h"

#include <gmock/gmock.h>

#include "tests/support/example_case.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(LinerDrawing, HasItsDimensionsAndTheParticles) {
  const Case mill = example_case();
  const std::string svg = liner_drawing(mill, DrawingFormat::svg);
  EXPECT_THAT(svg, HasSubstr("<svg"));
  EXPECT_THAT(svg, HasSubstr("pitch "));
  EXPECT_THAT(svg, HasSubstr("leading face "));
  EXPECT_THAT(svg, HasSubstr("plate "));
  EXPECT_THAT(svg, HasSubstr(" mm<"));
}

TEST(LinerDrawing, IsAPng) {
  EXPECT_THAT(liner_drawing(example_case(), DrawingFormat::png), StartsWith("\x89PNG"));
}

}  // namespace
}  // namespace millwear::orchestrator
