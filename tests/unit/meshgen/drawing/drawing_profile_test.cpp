#include "meshgen/drawing/drawing_profile.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "meshgen/drawing/dxf_groups.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear::meshgen {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A step up: (0, 0), (10, 0), (10, 5), (20, 5).
const std::string step =
    "0 LWPOLYLINE 8 LINER 90 4 70 0 10 0 20 0 10 10 20 0 10 10 20 5 10 20 20 5";

/// A DXF of words, whose blanks end the lines.
std::string dxf(const std::string& entities, const std::string& blocks = "",
                const std::string& tables = "", const std::string& unit = "4") {
  std::string words =
      "0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $DWGCODEPAGE 3 ANSI_1252 9 $INSUNITS 70 " + unit +
      " 0 ENDSEC ";
  if (!tables.empty()) words += "0 SECTION 2 TABLES " + tables + " 0 ENDSEC ";
  if (!blocks.empty()) words += "0 SECTION 2 BLOCKS " + blocks + " 0 ENDSEC ";
  words += "0 SECTION 2 ENTITIES " + (entities.empty() ? "" : entities + " ") + "0 ENDSEC 0 EOF ";
  for (char& c : words)
    if (c == ' ') c = '\n';
  return words;
}

std::string block(const std::string& name, const std::string& entities) {
  return "0 BLOCK 8 0 2 " + name + " 70 0 10 0 20 0 30 0 " + entities + " 0 ENDBLK 8 0";
}

class Drawing : public testing::Test {
 protected:
  [[nodiscard]] DrawingProfile read(const std::string& bytes,
                                    const std::optional<std::string>& layer = {}) const {
    write_file(file, bytes);
    return drawing_profile(file, layer);
  }
  [[nodiscard]] std::string refusal(const std::string& bytes,
                                    const std::optional<std::string>& layer = {}) const {
    try {
      static_cast<void>(read(bytes, layer));
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_THAT(text, StartsWith(file.string()));
      return text.substr(file.string().size());
    }
    return "it was taken";
  }
  orchestrator::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "liner.dxf";
};

/// The nodes in either sense as "x y, x y", to a thousandth.
std::string spoken(std::vector<Eigen::Vector2d> nodes) {
  if (nodes.front().x() > nodes.back().x()) std::reverse(nodes.begin(), nodes.end());
  std::string text;
  const auto round = [](double value) { return std::round(1e3 * value) / 1e3 + 0.0; };
  for (const auto& node : nodes)
    text += fmt::format("{}{:g} {:g}", text.empty() ? "" : ", ", round(node.x()), round(node.y()));
  return text;
}

TEST_F(Drawing, OfAPolylineIsItsNodes) {
  const auto drawn = read(dxf(step));
  EXPECT_EQ(spoken(drawn.nodes), "0 0, 10 0, 10 5, 20 5");
  EXPECT_THAT(drawn.left_out, IsEmpty());
}

TEST_F(Drawing, SaysItsUnit) {
  EXPECT_EQ(read(dxf(step, "", "", "1")).unit, LengthUnit::inch);
  EXPECT_EQ(read(dxf(step, "", "", "4")).unit, LengthUnit::millimetre);
  EXPECT_EQ(read(dxf(step, "", "", "6")).unit, LengthUnit::metre);
  EXPECT_FALSE(read(dxf(step, "", "", "0")).unit);
}

TEST_F(Drawing, HasNoUnitWhereThatIsNoNumber) {
  std::string text = dxf(step);
  const std::string unit = "$INSUNITS\n70\n4\n";
  text.replace(text.find(unit), unit.size(), "$INSUNITS\n1\nmm\n");
  EXPECT_FALSE(read(text).unit);
}

// Lines in any order and sense; a gap of a thousandth is closed, and one is drawn twice.
TEST_F(Drawing, JoinsLines) {
  EXPECT_EQ(spoken(read(dxf("0 LINE 8 A 10 20 20 5 11 10 21 5 0 LINE 8 A 10 0 20 0 11 10.001 21 0 "
                            "0 LINE 8 A 10 10 20 0 11 10 21 5 0 LINE 8 A 10 10 20 5 11 10 21 0"))
                       .nodes),
            "0 0, 10.001 0, 10 5, 20 5");
}

// A quarter of a circle about (10, 10) from (10, 0) to (20, 10), as an arc and as a bulge.
TEST_F(Drawing, CutsArcsIntoChordsOfADegree) {
  for (const std::string arc :
       {"0 LINE 8 A 10 0 20 0 11 10 21 0 0 ARC 8 A 10 10 20 10 40 10 50 270 51 360",
        "0 LWPOLYLINE 8 A 90 3 70 0 10 0 20 0 10 10 20 0 42 0.41421356237309503 10 20 20 10"}) {
    const auto nodes = read(dxf(arc)).nodes;
    EXPECT_GE(nodes.size(), 91U);
    for (const auto& node : nodes) {
      if (node.x() > 10.0) {
        EXPECT_NEAR((node - Eigen::Vector2d(10, 10)).norm(), 10.0, 1e-6);
        EXPECT_LE(node.y(), 10.0 + 1e-9);
      }
    }
  }
}

TEST_F(Drawing, PutsBlocksWhereTheyAreInserted) {
  const std::string blocks = block("STEP", step);
  // Scaled by two, turned by 90 degrees, moved.
  EXPECT_EQ(spoken(read(dxf("0 INSERT 8 0 2 STEP 10 100 20 50 41 2 42 2 50 90", blocks)).nodes),
            "90 90, 90 70, 100 70, 100 50");
  // Mirrored by a scale below zero.
  EXPECT_EQ(spoken(read(dxf("0 INSERT 8 0 2 STEP 10 0 20 0 41 -1 42 1 50 0", blocks)).nodes),
            "-20 5, -10 5, -10 0, 0 0");
  // In a block that is inserted, turned upside down by its extrusion.
  EXPECT_EQ(spoken(read(dxf("0 INSERT 8 0 2 OUTER 10 1 20 1 210 0 220 0 230 -1",
                            blocks + " " + block("OUTER", "0 INSERT 8 0 2 STEP 10 2 20 2")))
                       .nodes),
            "-23 8, -13 8, -13 3, -3 3");
}

// A row of three makes one curve, each step beginning where the last one ends.
TEST_F(Drawing, RepeatsBlocksInArrays) {
  const std::string flat = "0 LINE 8 LINER 10 0 20 0 11 10 21 0";
  EXPECT_EQ(
      spoken(read(dxf("0 INSERT 8 0 2 FLAT 10 0 20 0 70 3 71 1 44 10 45 0", block("FLAT", flat)))
                 .nodes),
      "0 0, 10 0, 20 0, 30 0");
}

TEST_F(Drawing, IsSeenFromTheSideOfItsExtrusion) {
  EXPECT_EQ(
      spoken(read(dxf("0 LWPOLYLINE 8 LINER 90 4 70 0 210 0 220 0 230 -1 10 0 20 0 10 10 20 0 "
                      "10 10 20 5 10 20 20 5"))
                 .nodes),
      "-20 5, -10 5, -10 0, 0 0");
}

// A spline of degree one is its control polygon; one of degree two with three points a parabola.
TEST_F(Drawing, FollowsSplines) {
  const auto nodes = read(dxf("0 SPLINE 8 A 70 8 71 2 72 6 73 3 74 0 40 0 40 0 40 0 40 1 40 1 40 1 "
                              "10 0 20 0 30 0 10 1 20 2 30 0 10 2 20 0 30 0"))
                         .nodes;
  EXPECT_GT(nodes.size(), 10U);
  for (const auto& node : nodes) EXPECT_NEAR(node.y(), node.x() * (2.0 - node.x()), 1e-9);
}

TEST_F(Drawing, FollowsEllipses) {
  for (const auto& node :
       read(dxf("0 ELLIPSE 8 A 10 0 20 0 30 0 11 2 21 0 31 0 40 0.5 41 0 42 3.14159265358979"))
           .nodes) {
    EXPECT_NEAR(0.25 * node.x() * node.x() + node.y() * node.y(), 1.0, 1e-9);
    EXPECT_GE(node.y(), -1e-9);
  }
}

// The control frame of a spline-fit polyline (vertex flag 16) is not the curve.
TEST_F(Drawing, TakesOldPolylinesWithTheirFit) {
  EXPECT_EQ(
      spoken(read(dxf("0 POLYLINE 8 A 66 1 70 4 0 VERTEX 8 A 10 0 20 0 70 16 0 VERTEX 8 A 10 10 "
                      "20 9 70 16 0 VERTEX 8 A 10 0 20 0 70 8 0 VERTEX 8 A 10 10 20 5 70 8 0 "
                      "VERTEX 8 A 10 20 20 5 70 8 0 SEQEND"))
                 .nodes),
      "0 0, 10 5, 20 5");
}

TEST_F(Drawing, LeavesOutWhatIsNoProfile) {
  const auto drawn =
      read(dxf(step +
               " 0 LWPOLYLINE 8 FRAME 90 4 70 1 10 -90 20 -90 10 90 20 -90 10 90 20 90 10 -90 20 90"
               " 0 TEXT 8 NOTES 10 0 20 0 40 2.5 1 liner 0 CIRCLE 8 BOLTS 10 5 20 5 40 1"
               " 0 LINE 8 AXIS 10 50 20 0 11 50 21 9 0 DIMENSION 8 DIM 10 0 20 0 2 *D1"
               " 0 3DFACE 8 SHELL 10 0 20 0 30 0 0 LINE 8 PAPER 67 1 10 0 20 0 11 900 21 0"));
  EXPECT_EQ(spoken(drawn.nodes), "0 0, 10 0, 10 5, 20 5");
  EXPECT_THAT(drawn.left_out,
              testing::UnorderedElementsAre(
                  HasSubstr("LWPOLYLINE (line 48) on layer `FRAME`: it is closed"),
                  HasSubstr("TEXT (line 72) on layer `NOTES`: it is a text"),
                  HasSubstr("CIRCLE (line 84) on layer `BOLTS`: it is closed"),
                  HasSubstr("LINE (line 94) on layer `AXIS`: it is shorter than the profile"),
                  HasSubstr("DIMENSION (line 106) on layer `DIM`: it is a dimension"),
                  HasSubstr("3DFACE (line 116) on layer `SHELL`: it is three-dimensional"),
                  HasSubstr("LINE (line 126) on layer `PAPER`: it is in paper space")));
}

TEST_F(Drawing, LeavesOutWhatIsNotShown) {
  const std::string tables =
      "0 TABLE 2 LAYER 70 3 0 LAYER 2 HIDDEN 70 0 62 -7 6 CONTINUOUS 0 LAYER 2 COLD 70 1 62 7 6 "
      "CONTINUOUS 0 LAYER 2 LINER 70 0 62 7 6 CONTINUOUS 0 ENDTAB";
  const auto drawn =
      read(dxf(step + " 0 LINE 8 HIDDEN 10 0 20 0 11 99 21 0 0 LINE 8 COLD 10 0 20 0 11 99 21 0",
               "", tables));
  EXPECT_EQ(spoken(drawn.nodes), "0 0, 10 0, 10 5, 20 5");
  EXPECT_THAT(drawn.left_out, ElementsAre(HasSubstr("its layer is off"), HasSubstr("frozen")));
}

TEST_F(Drawing, KnowsLayersInTheCodePageOfTheFile) {
  const std::string old =
      dxf("0 LINE 8 Rep\xe8re 10 0 20 0 11 9 21 0 0 LINE 8 X 10 0 20 9 11 9 21 9 "
          "0 TEXT 8 \xc9t\xe9 10 0 20 0 40 1 1 x");
  const auto drawn = read(old, "Rep\xc3\xa8re");
  EXPECT_EQ(spoken(drawn.nodes), "0 0, 9 0");
  EXPECT_THAT(drawn.left_out, ElementsAre(HasSubstr("`\xc3\x89t\xc3\xa9`")));
  EXPECT_THAT(refusal(old, "Repere"),
              HasSubstr("no curve is on layer `Repere`; they are on `Rep\xc3\xa8re`, `X`"));
}

/// The same drawing as a binary DXF, as R13 and later write it.
std::string binary(const std::string& text) {
  std::string bytes("AutoCAD Binary DXF\r\n\x1a\0", 22);
  for (const DxfGroup& group : dxf_groups(text, "x.dxf")) {
    const auto put = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    put(static_cast<std::int16_t>(group.code));
    if (group.code >= 10 && group.code < 60) {
      put(std::stod(group.value));
    } else if (group.code >= 60 && group.code < 80) {
      put(static_cast<std::int16_t>(std::stoi(group.value)));
    } else if (group.code >= 90 && group.code < 100) {
      put(static_cast<std::int32_t>(std::stoi(group.value)));
    } else {
      bytes += group.value + '\0';
    }
  }
  return bytes;
}

TEST_F(Drawing, IsReadFromABinaryFile) {
  const std::string bytes = binary(dxf(step));
  const auto drawn = read(bytes);
  EXPECT_EQ(spoken(drawn.nodes), "0 0, 10 0, 10 5, 20 5");
  EXPECT_EQ(drawn.unit, LengthUnit::millimetre);
  EXPECT_THAT(refusal(bytes.substr(0, bytes.size() - 20)), HasSubstr("the file is cut off"));
}

TEST_F(Drawing, IsRefusedWhereSomethingIsBroken) {
  EXPECT_THAT(refusal(""), HasSubstr(":1: the drawing ends before its EOF"));
  EXPECT_THAT(refusal("x,y\n0,1\n"), HasSubstr(":1: `x,y` is no group code of a DXF; give a DXF"));
  const std::string whole = dxf(step);
  EXPECT_THAT(refusal(whole.substr(0, whole.size() / 2)), HasSubstr("the file is cut off"));
  EXPECT_THAT(refusal(dxf("0 LINE 8 A 10 q1.6897 20 0 11 9 21 0")),
              HasSubstr(":28: `q1.6897` is not a number (of group 10)"));
  EXPECT_THAT(refusal(dxf("0 LINE 8 A 1x 0 20 0 11 9 21 0")),
              HasSubstr(":27: `1x` is no group code of a DXF; mend the drawing"));
  EXPECT_THAT(refusal(dxf("0 LWPOLYLINE 8 A 90 3 70 0 10 0 20 0 10 9 20 0")),
              HasSubstr(":24: a polyline says that it has 3 vertices, and has 2"));
  const auto spline = [&](const std::string& knots) {
    return refusal(dxf("0 SPLINE 8 A 71 2 72 6 73 3 " + knots + " 10 0 20 0 10 1 20 2 10 2 20 0"));
  };
  EXPECT_THAT(spline("40 0 40 0 40 0 40 1 40 1"), HasSubstr("takes 6 knots, and has 5"));
  EXPECT_THAT(spline("40 0 40 0 40 0 40 1 40 0 40 1"), HasSubstr("the knots of a spline fall"));
}

TEST_F(Drawing, IsRefusedWhereItIsNoFileOrTooLarge) {
  EXPECT_THAT([&] { static_cast<void>(drawing_profile(folder.path() / "none.dxf", {})); },
              testing::ThrowsMessage<InputError>(HasSubstr("none.dxf: there is no such file")));
  write_file(file, dxf(step));
  std::filesystem::resize_file(file, 200 * 1024 * 1024);
  EXPECT_THAT([&] { static_cast<void>(drawing_profile(file, {})); },
              testing::ThrowsMessage<InputError>(HasSubstr("the file is over 64 MiB")));
}

TEST_F(Drawing, IsRefusedWhereTheProfileIsNotClear) {
  EXPECT_THAT(refusal(dxf("")), HasSubstr("nothing is drawn that could be a profile"));
  EXPECT_THAT(refusal(dxf("", block("STEP", step))), HasSubstr("insert the block"));
  EXPECT_THAT(refusal(dxf("0 3DFACE 8 A 10 0 20 0 30 0")), HasSubstr("it is three-dimensional"));
  EXPECT_THAT(refusal(dxf("0 LINE 8 A 10 0 20 0 30 0 11 9 21 0 31 5")), HasSubstr("is not flat"));
  EXPECT_THAT(refusal(dxf("0 LWPOLYLINE 8 A 90 3 70 1 10 0 20 0 10 9 20 0 10 9 20 9")),
              HasSubstr("no open curve is drawn (left out: LWPOLYLINE (line 24) on layer `A`"));
  EXPECT_THAT(refusal(dxf("0 LINE 8 A 10 0 20 0 11 9 21 0 0 LINE 8 B 10 0 20 5 11 9 21 5")),
              HasSubstr("two open curves are drawn, LINE (line 24) on layer `A` and LINE (line 36) "
                        "on layer `B`"));
  EXPECT_THAT(refusal(dxf("0 LINE 8 A 10 0 20 0 11 9 21 0 0 LINE 8 A 10 9 20 0 11 12 21 1 "
                          "0 LINE 8 A 10 9 20 0 11 12 21 -1")),
              HasSubstr("more than two curves meet where the profile ends"));
}

}  // namespace
}  // namespace millwear::meshgen
