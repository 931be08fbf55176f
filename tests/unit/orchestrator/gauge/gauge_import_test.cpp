#include "orchestrator/gauge/gauge_import.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "meshgen/drawing/dxf_polyline.h"
#include "mill/base/failure.h"
#include "mill/liner/parametric_lifter.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"
#include "wear/evolve/signed_surface.h"
#include "wear/gauge/profile_comparison.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using wear::Curve;

Case mill_of(const std::filesystem::path& folder) {
  Case mill = example_case();
  mill.liner = profile_of(mill.liner.sector, {0.04, 0.05, 0.2, 0.5});
  mill.file = folder / "mill.toml";
  return mill;
}

/// The new liner with its crest cut at `height` and its leading face worn back to `face`.
Curve worn(const Case& mill, double height, double face, int count = 300) {
  Curve nodes;
  for (auto node : wear::even_places(mill.liner, count)) {
    if (radius_of(mill.liner.sector, node) < mill.liner.sector.plate_radius - 0.003)
      node = {std::min(node.x(), face), std::min(node.y(), height)};
    nodes.push_back(node);
  }
  nodes.front() = mill.liner.nodes.front();
  nodes.back() = mill.liner.nodes.back();
  return nodes;
}

/// Nearly normal scatter of standard deviation 1.
double scatter(std::uint64_t counter) {
  double sum = -6.0;
  for (int k = 0; k < 12; ++k) {
    std::uint64_t z = (12 * counter + k + 1) * 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    sum += static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  return sum;
}

std::string csv_of(const Curve& curve, const std::string& head, double scale,
                   const wear::RigidMotion& motion, double noise = 0.0) {
  std::string text = head + "\n";
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Eigen::Vector2d off(scatter(2 * i), scatter(2 * i + 1));
    const Eigen::Vector2d seen = scale * motion(curve[i] + noise * off);
    text += std::to_string(seen.x()) + "," + std::to_string(seen.y()) + "\n";
  }
  return text;
}

const wear::RigidMotion in_place{0.0, Eigen::Vector2d::Zero()};
const wear::RigidMotion gauge_frame{0.1, {0.5, -0.2}};

class GaugeImport : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& name, const std::string& text) {
    put_text(folder.path() / name, text);
    return folder.path() / name;
  }
  ImportRequest request(double hours, std::optional<CurveFile> curve) {
    return {.curve = std::move(curve),
            .operating_hours = hours,
            .error = 1e-3,
            .align = AlignmentMode::by_file,
            .mirror = false,
            .lifter_height = {},
            .plate_thickness = {},
            .reference = {},
            .folder = folder.path() / "gauge"};
  }
  ImportRequest height(double hours, double metres) {
    ImportRequest reading = request(hours, {});
    reading.lifter_height = metres;
    return reading;
  }
  ImportedReading take(const ImportRequest& wanted) {
    auto imported = prepare_reading(mill, wanted);
    publish_reading(imported, wanted.folder);
    return imported;
  }
  std::string refusal(const ImportRequest& wanted) {
    return failure_of<InputError>([&] { static_cast<void>(prepare_reading(mill, wanted)); });
  }
  std::string table() { return text_of(folder.path() / "gauge" / gauge_table_name); }

  TemporaryFolder folder;
  Case mill = mill_of(folder.path());
};

TEST_F(GaugeImport, PublishesAHeight) {
  const auto imported = take(height(5112, 0.03));
  EXPECT_FALSE(imported.replaces);
  EXPECT_EQ(table(),
            "# millwear gauge readings 1\n"
            "operating_hours,lifter_height_m,plate_thickness_m,profile_csv,error_m\n"
            "5112,0.03,,,0.001\n");
}

TEST_F(GaugeImport, KeepsReadingsInOrderOfTimeAndReplacesTheSameHour) {
  take(height(3000, 0.02));
  take(height(1000, 0.03));
  EXPECT_TRUE(take(height(3000, 0.021)).replaces);
  const auto readings = readings_in(folder.path() / "gauge", mill);
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].operating_hours, 1000.0);
  EXPECT_EQ(readings[1].lifter_height, 0.021);
}

TEST_F(GaugeImport, RefusesSteelThatGrowsAndWritesNothing) {
  take(height(1000, 0.02));
  const std::string before = table();
  EXPECT_THAT(refusal(height(2000, 0.03)),
              HasSubstr("grows from 20 mm at 1000 h to 30 mm at 2000"));
  EXPECT_THAT(refusal(height(500, 0.01)), HasSubstr("grows from 10 mm at 500 h to 20 mm at 1000"));
  EXPECT_EQ(table(), before);
  EXPECT_EQ(refusal(height(2000, 0.02)), "");
}

// The new lifter is 40 mm high: 44 mm is three errors and a millimetre more.
TEST_F(GaugeImport, RefusesAnotherMillsLifter) {
  EXPECT_EQ(refusal(height(10, 0.0439)), "");
  EXPECT_THAT(refusal(height(10, 0.0441)), HasSubstr("above the new liner"));
  ImportRequest plate = request(10, {});
  plate.plate_thickness = plate_thickness(mill.liner) + 0.0041;
  EXPECT_THAT(refusal(plate), HasSubstr("the plate's surface lies"));
}

TEST_F(GaugeImport, ProfileInTheMasterFrameStaysWhereItIs) {
  const auto curve = worn(mill, 0.025, 0.01);
  const auto file = put("scan.csv", csv_of(curve, "xi_m,eta_m", 1.0, in_place));
  const auto imported = take(request(5112, CurveFile{file, {}, {}}));
  EXPECT_NEAR(imported.reading.lifter_height.value(), 0.025, 1e-6);
  EXPECT_THAT(table(), HasSubstr("\n5112,,,profile_0005112h.csv,0.001\n"));
  const auto kept = readings_in(folder.path() / "gauge", mill).at(0).profile.value();
  EXPECT_EQ(kept.nodes, imported.reading.profile->nodes);
  EXPECT_LT(wear::compare(kept, {mill.liner.sector, curve}).hausdorff, 1.3e-4);
}

// 20,000 points with 0.5 mm of noise, in millimetres and in a frame of its own.
TEST_F(GaugeImport, FitsADenseNoisyScan) {
  const auto curve = worn(mill, 0.025, 0.01, 20000);
  const auto file = put("scan.csv", csv_of(curve, "x,y", 1e3, gauge_frame, 5e-4));
  const auto imported = take(request(5112, CurveFile{file, LengthUnit::millimetre, {}}));
  EXPECT_EQ(imported.points, 20000U);
  EXPECT_LT(imported.reading.profile->nodes.size(), 400U);
  EXPECT_EQ(first_crossing(*imported.reading.profile), std::pair(-1, -1));
  ASSERT_TRUE(imported.fit);
  EXPECT_NEAR(imported.alignment->motion.angle, -0.1, 2e-3);
  EXPECT_LT(wear::compare(*imported.reading.profile, {mill.liner.sector, curve}).rms_distance,
            3e-4);
  EXPECT_NEAR(imported.reading.lifter_height.value(), 0.025, 4e-4);
}

TEST_F(GaugeImport, TakesADrawingInItsUnit) {
  const auto file = folder.path() / "drawing.DXF";
  meshgen::write_dxf_polyline(worn(mill, 0.025, 0.01), "LINER", file);
  ImportRequest wanted = request(5112, CurveFile{file, {}, "LINER"});
  EXPECT_NEAR(take(wanted).reading.lifter_height.value(), 0.025, 1e-4);
  wanted.curve->layer = "PLATE";
  EXPECT_THAT(refusal(wanted), HasSubstr("no curve is on layer `PLATE`; they are on `LINER`"));
  wanted.curve->layer = {};
  wanted.curve->unit = LengthUnit::metre;
  EXPECT_THAT(refusal(wanted), HasSubstr("say its unit with --unit"));
}

TEST_F(GaugeImport, MirrorsWhatWasSeenFromTheOtherEnd) {
  const auto curve = worn(mill, 0.025, 0.01);
  const auto file = put("scan.csv", csv_of(wear::mirror_image(curve), "x,y", 1.0, gauge_frame));
  ImportRequest wanted = request(5112, CurveFile{file, {}, {}});
  EXPECT_THAT(refusal(wanted), AllOf(StartsWith(file.string()), HasSubstr("mirror")));
  wanted.mirror = true;
  EXPECT_LT(
      wear::compare(take(wanted).reading.profile.value(), {mill.liner.sector, curve}).hausdorff,
      3e-4);
}

TEST_F(GaugeImport, ProfilesOfOneHourReplaceEachOther) {
  const auto first = put("a.csv", csv_of(worn(mill, 0.03, 0.02), "xi_m,eta_m", 1.0, in_place));
  const auto second = put("b.csv", csv_of(worn(mill, 0.02, 0.01), "xi_m,eta_m", 1.0, in_place));
  take(request(100.5, CurveFile{first, {}, {}}));
  EXPECT_TRUE(take(request(100.5, CurveFile{second, {}, {}})).replaces);
  const auto readings = readings_in(folder.path() / "gauge", mill);
  ASSERT_EQ(readings.size(), 1U);
  EXPECT_NEAR(readings[0].lifter_height.value(), 0.02, 1e-6);
}

TEST_F(GaugeImport, NamesTheFileAndLineOfBadInput) {
  const auto refused = [&](const std::string& text, std::optional<LengthUnit> unit = {}) {
    const auto file = put("bad.csv", text);
    const std::string problem = refusal(request(1, CurveFile{file, unit, {}}));
    EXPECT_THAT(problem, StartsWith(file.string() + ":"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "gauge"));
    return problem.substr(std::min(problem.size(), file.string().size()));
  };
  EXPECT_THAT(refused(""), StartsWith(":1: the table is empty"));
  EXPECT_THAT(refused("a,b\n1,2\n"), StartsWith(":1: the header names neither"));
  EXPECT_THAT(refused("x,y\n1,2\n1,two\n"), StartsWith(":3: `two` is not a number"));
  EXPECT_THAT(refused("x,y\n1\n"), StartsWith(":2: 1 values where"));
  EXPECT_THAT(refused("xi_m,eta_m\n0,0\n", LengthUnit::millimetre),
              StartsWith(":1: `xi_m` is in m and --unit says mm"));
  EXPECT_THAT(refused("x,y\n0,0\n0.1,0\n"), HasSubstr("2 points are no profile"));
  EXPECT_THAT(refused("x,y\n0,0\n120,40\n240,0\n"), HasSubstr("say its unit with --unit"));
  EXPECT_THAT(refused("xi_m,eta_m\n-0.05,0.02\n0,0.04\n0.05,0.02\n"),
              HasSubstr("ends neither on the plate nor at the sector edges"));
}

TEST_F(GaugeImport, RefusesAProfileThatStandsOutOfTheNewLiner) {
  auto curve = mill.liner.nodes;
  curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(curve.size() / 2), {0.0, 0.06});
  const auto file = put("scan.csv", csv_of(curve, "xi_m,eta_m", 1.0, in_place));
  EXPECT_THAT(refusal(request(1, CurveFile{file, {}, {}})), HasSubstr("above the new liner"));
}

TEST_F(GaugeImport, ReportShowsHeightsAndProfiles) {
  const auto file = put("scan.csv", csv_of(worn(mill, 0.025, 0.01), "xi_m,eta_m", 1.0, in_place));
  take(height(0, 0.04));
  take(request(100, CurveFile{file, {}, {}}));
  ImportRequest plate = request(200, {});
  plate.plate_thickness = 0.01;
  take(plate);
  CampaignResults data{};
  add_readings(readings_in(folder.path() / "gauge", mill), data);
  ASSERT_EQ(data.measured.size(), 2U);
  EXPECT_EQ(data.measured[0].height, 0.04);
  EXPECT_EQ(data.measured[1].operating_hours, 100.0);
  EXPECT_EQ(data.measured[1].error, 1e-3);
  ASSERT_EQ(data.measured_profiles.size(), 1U);
  EXPECT_EQ(data.measured_profiles[0].operating_hours, 100.0);
}

TEST_F(GaugeImport, FolderWithoutATableHasNoReadings) {
  EXPECT_TRUE(readings_in(folder.path() / "gauge", mill).empty());
  EXPECT_THROW(static_cast<void>(needed_readings_in(folder.path() / "gauge", mill)), InputError);
}

TEST(ProfileName, SortsByHours) {
  EXPECT_EQ(profile_name(5112), "profile_0005112h.csv");
  EXPECT_EQ(profile_name(0), "profile_0000000h.csv");
  EXPECT_EQ(profile_name(100.5), "profile_0000100.5h.csv");
  EXPECT_EQ(profile_name(15410.637), "profile_0015410.637h.csv");
}

}  // namespace
}  // namespace millwear::orchestrator
