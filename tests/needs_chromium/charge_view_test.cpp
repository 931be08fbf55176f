#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "orchestrator/report/base64.h"
#include "orchestrator/report/deflate.h"
#include "orchestrator/report/report.h"
#include "tests/needs_chromium/browser.h"
#include "tests/support/synthetic_campaign.h"

namespace millwear::orchestrator {
namespace {

// Two particles, two frames. In 16 bits x runs from one end of `across` to the other, y of `along`.
constexpr auto charge = R"({"locked_slip": 0.05, "slice_length": 0.25, "classes": [
  {"name": "steel 60 mm", "material": "steel", "diameter": 0.06},
  {"name": "ore 100 mm", "material": "ore", "diameter": 0.1}], "cycles": [
  {"cycle": 0, "frames": FRAMES, "pictures": {"section": "data:image/png;base64,"}},
  {"cycle": 1, "frames": null}, {"cycle": 2, "frames": FRAMES, "pictures": {}}]})";
constexpr auto frames =
    R"({"particles": 2, "thinning": 3, "times": [5, 5.1], "mill_angles": [0, 0.1],
  "across": [-4, 4], "along": [0, 0.25], "step": 0.01, "classes": "CLASSES", "first": "FIRST",
  "changes": "CHANGES"})";

std::string packed(const std::vector<std::uint8_t>& bytes) { return base64(deflated(bytes)); }

std::string replaced(std::string text, const std::string& name, const std::string& value) {
  for (auto at = text.find(name); at != std::string::npos; at = text.find(name))
    text.replace(at, name.size(), value);
  return text;
}

std::string charge_data() {
  std::string data = replaced(charge, "FRAMES", frames);
  data = replaced(data, "CLASSES", packed({0, 1}));
  data = replaced(data, "FIRST", packed({0, 0, 255, 255, 0, 0, 255, 255, 255, 255, 0, 0}));
  return replaced(data, "CHANGES", packed({1, 254, 3, 252, 128, 127}));
}

class ChargeView : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder); }

  /// The report of a synthetic campaign in a browser, where `script` has run at its end.
  std::string page_after(const std::string& script) const {
    std::string page = report_html(synthetic_campaign(3, 2));
    const std::string end = "</body>";
    page.replace(page.rfind(end), end.size(),
                 "<script>data.charge = " + charge_data() + ";" + script + "</script></body>");
    return drawn(page, folder);
  }

  nlohmann::json value_of(const std::string& expression) const {
    const auto page = page_after(
        "document.body.append(element('pre', {id: 'value'}, JSON.stringify(" + expression + ")));");
    const std::string start = "<pre id=\"value\">";
    return nlohmann::json::parse(part_between(page, start, "</pre>").substr(start.size()));
  }

  /// The section of the view, built where the page begins.
  std::string view(const std::string& before = "") const {
    return part_between(
        page_after(before + "const view = element('section', {id: 'tried'});"
                            "document.querySelector('main').prepend(view); startChargeView(view);"),
        "id=\"tried\"", "</section>");
  }

  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("charge_view_" + std::to_string(::getpid()));
};

TEST_F(ChargeView, DecodesPlacesAndAddsTheMovesToThem) {
  const auto decoded = value_of(
      "(() => { const f = decodedFrames(data.charge.cycles[0].frames);"
      "return {places: [...f.places], radii: [...f.radii], times: f.times}; })()");
  const std::vector<double> places = {-4, 0, 4, 4, 0.25, -4, -3.99, 0.03, 2.72, 3.98, 0.21, -2.73};
  ASSERT_EQ(decoded["places"].size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR(decoded["places"][i].get<double>(), places[i], 1e-6) << i;
  EXPECT_NEAR(decoded["radii"][1].get<double>(), 0.05, 1e-7);
  EXPECT_EQ(decoded["times"][0].get<double>(), 0.0);
}

TEST_F(ChargeView, FindsTheIntervalOfATimeAndStaysInsideOfTheFrames) {
  const auto found =
      value_of("[-1, 0.3, 0.6, 9].map((t) => intervalAt({times: [0, 0.4, 0.8]}, t))");
  const auto near = [&](int i, int interval, double share) {
    EXPECT_EQ(found[i]["interval"].get<int>(), interval);
    EXPECT_NEAR(found[i]["share"].get<double>(), share, 1e-9);
  };
  near(0, 0, 0.0);
  near(1, 0, 0.75);
  near(2, 1, 0.5);
  near(3, 1, 1.0);
}

// The mill turns with 1 rad/s: at (-3, 0.15) the wall rises with 3 m/s. So does the first particle,
// and along the axis it leaves the slice of 0.25 m at 0.24 and is back at 0.001: 0.11 m/s. Halfway
// the wall also moves sideways, with 0.15 m/s: 0.19 m/s in all, less than a twentieth of the
// plate's 3.9 m/s. The second stands still. The balls are equal, so half of
// their mass moves with the mill.
TEST_F(ChargeView, TellsWhatMovesWithTheMillAcrossTheEndOfTheSlice) {
  const auto movement = value_of(
      "movementOf({particles: 2, times: [0, 0.1], classes: [0, 0],"
      "places: [-3, 0.24, 0, 0, 0.1, -3, -3, 0.001, 0.3, 0, 0.1, -3]}, 1)");
  EXPECT_EQ(movement["withMill"].size(), 1u);
  EXPECT_EQ(movement["withMill"][0][0].get<std::string>(), "steel");
  EXPECT_NEAR(movement["withMill"][0][1].get<double>(), 0.5, 1e-12);
  EXPECT_NEAR(movement["fast"].get<double>(), std::hypot(3.0, 0.11), 1e-6);
}

// A square of 4 x 3 with a notch of 1 x 1 that is narrower than what stands over it.
TEST_F(ChargeView, CutsAnUndercutSectionIntoTriangles) {
  const auto areas = value_of(
      "trianglesOf([[0, 0], [4, 0], [4, 1], [3, 1], [3, 2], [4, 2], [4, 3], [0, 3]])"
      ".map(([a, b, c]) => turnOf(a, b, c) / 2)");
  double sum = 0.0;
  for (const auto& area : areas) {
    EXPECT_GT(area.get<double>(), 0.0);
    sum += area.get<double>();
  }
  EXPECT_NEAR(sum, 11.0, 1e-12);
}

// 52 rows on a plate of 3.9005 m in a shell of 4 m, two facets on the plate and twelve on the
// shell; at either side the sector reaches 1e-4 rad over its edge. The place at xi = 0 is six
// o'clock, and xi > 0 lies along the rotation: from there to the left. An eye before the slice sees
// the faces at y = 0 go around anticlockwise.
TEST_F(ChargeView, PutsTheSteelOfASectorBetweenPlateAndShell) {
  const auto mesh = value_of(
      "[...sectorMesh([-1, 0, 1].map((side) => pointAt(data.sector.plate_radius, side * Math.PI / "
      "data.sector.rows)))]");
  double area = 0.0;
  for (std::size_t at = 0; at < mesh.size(); at += 18) {
    const auto number = [&](std::size_t i) { return mesh[at + i].get<double>(); };
    if (number(4) == -1.0)
      area += 0.5 * ((number(6) - number(0)) * (number(14) - number(2)) -
                     (number(8) - number(2)) * (number(12) - number(0)));
  }
  const double width = 2.0 * std::numbers::pi / 52 + 2e-4;
  EXPECT_NEAR(area, 6.0 * 16.0 * std::sin(width / 12) - std::pow(3.9005, 2) * std::sin(width / 2),
              1e-5);
  // First facet: from the trailing edge, at the right, to six o'clock; its normal points up.
  EXPECT_NEAR(mesh[0].get<double>(), 3.9005 * std::sin(width / 2), 1e-5);
  EXPECT_NEAR(mesh[12].get<double>(), 0.0, 1e-6);
  EXPECT_NEAR(mesh[14].get<double>(), -3.9005, 1e-6);
  EXPECT_GT(mesh[5].get<double>(), 0.99);
}

// Without WebGL 2 the picture stands in, or a sentence where there is none. A browser without a
// window tells of no intersections, so the view is told that it is near.
TEST_F(ChargeView, ShowsNewBesideWornAndStandsInWithoutWebgl) {
  const auto section = view(
      "HTMLCanvasElement.prototype.getContext = () => null;"
      "window.IntersectionObserver = class { constructor(tell) { this.tell = tell; }"
      "observe() { this.tell([{isIntersecting: true}]); } };");
  EXPECT_EQ(count_of(section, "<canvas"), 2u);
  EXPECT_EQ(count_of(section, "<option value=\"0\">cycle 0, from"), 2u);
  EXPECT_EQ(count_of(section, "<option value=\"1\">cycle 2, from"), 2u);
  EXPECT_EQ(count_of(section, "class=\"charge-view flat\""), 1u);
  EXPECT_EQ(count_of(section, "<img src=\"data:image/png;base64,\""), 1u);
  EXPECT_EQ(count_of(section, "by a browser with WebGL 2"), 1u);
  EXPECT_EQ(count_of(section, "One particle in 3 is shown, 2 in all."), 2u);
}

TEST_F(ChargeView, WithoutFramesIsOneSentence) {
  const auto section = view("for (const one of data.charge.cycles) one.frames = null;");
  EXPECT_NE(section.find("No frames of the charge were kept"), std::string::npos);
  EXPECT_EQ(count_of(section, "<canvas"), 0u);
}

}  // namespace
}  // namespace millwear::orchestrator
