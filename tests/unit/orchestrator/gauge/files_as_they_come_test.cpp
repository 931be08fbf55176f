#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "meshgen/drawing/dxf_polyline.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/gauge/gauge_import.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr double degrees = 180.0 / std::numbers::pi;

ImportRequest request_for(const fs::path& file, const fs::path& folder,
                          std::optional<std::string> layer = {}) {
  return {.curve = CurveFile{file, {}, std::move(layer)},
          .operating_hours = 100.0,
          .error = 1e-3,
          .align = AlignmentMode::by_file,
          .mirror = false,
          .lifter_height = {},
          .plate_thickness = {},
          .reference = {},
          .folder = folder};
}

/// A worn lifter of the pilot mill as gauges, spreadsheets and CAD programs write it.
class FileAsItComes : public testing::Test {
 protected:
  [[nodiscard]] ImportedReading take(const fs::path& file,
                                     std::optional<std::string> layer = {}) const {
    return prepare_reading(mill, request_for(file, folder.path(), std::move(layer)));
  }
  [[nodiscard]] std::string refusal(const fs::path& file) const {
    try {
      static_cast<void>(take(file));
    } catch (const InputError& error) {
      return error.what();
    }
    return "it was taken";
  }
  /// Whether it is the lifter, 37.0 mm high (37.1 with arcs of the plate).
  static void expect_the_lifter(const ImportedReading& imported) {
    EXPECT_NEAR(*imported.reading.lifter_height, 0.03705, 1e-4);
    EXPECT_NEAR(*imported.reading.plate_thickness, 0.035, 5e-5);
    EXPECT_NEAR(degrees * leading_face_angle(*imported.reading.profile), 41.1, 0.1);
  }

  Case mill = read_case(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml");
  fs::path inputs = fs::path(MILLWEAR_CASES).parent_path() / "tests" / "inputs";
  TemporaryFolder folder;
};

class ReadableFile : public FileAsItComes, public testing::WithParamInterface<const char*> {};

TEST_P(ReadableFile, GivesTheLifter) { expect_the_lifter(take(inputs / GetParam())); }

INSTANTIATE_TEST_SUITE_P(Inputs, ReadableFile,
                         testing::Values("excel_utf8_bom.csv", "excel_german.csv",
                                         "tab_separated.csv", "quoted_header_mm.csv",
                                         "plus_signs.csv", "loose_lines_and_arcs.dxf",
                                         "loose_lines_in_a_frame.dxf",
                                         "block_with_insert_turned.dxf", "seen_from_behind.dxf",
                                         "layer_name_1252.dxf", "plate_by_bulges.dxf"),
                         [](const auto& file) {
                           const std::string name = file.param;
                           return name.substr(0, name.find('.'));
                         });

TEST_F(FileAsItComes, IsFoundByALayerInAnotherCodePage) {
  expect_the_lifter(take(inputs / "layer_name_1252.dxf",
                         "Rep\xc3\xa8re pi\xc3\xa8"
                         "ce"));
}

TEST_F(FileAsItComes, NamesWhatOfADrawingIsLeftOut) {
  EXPECT_THAT(take(inputs / "loose_lines_in_a_frame.dxf").left_out,
              testing::ElementsAre(AllOf(HasSubstr("LWPOLYLINE (line "), HasSubstr("`FRAME`"),
                                         HasSubstr("it is closed"))));
}

TEST_F(FileAsItComes, IsRefusedByLineOrEntity) {
  EXPECT_THAT(
      refusal(inputs / "mixed_up_order.csv"),
      HasSubstr("mixed_up_order.csv:11: the points of lines 11 to 13 are not in their order"));
  EXPECT_THAT(refusal(inputs / "block_never_inserted.dxf"), HasSubstr("nothing is drawn"));
  // Its spline is a smooth curve far over the plate: one curve with the polyline, and not this
  // liner.
  EXPECT_THAT(refusal(inputs / "polyline_and_spline.dxf"),
              AllOf(HasSubstr("ends neither on the plate"), HasSubstr("SPLINE (line 76)")));
}

/// A file that is cut off after so many bytes is refused, or is nearly the same profile.
class CutOffFile : public FileAsItComes {
 protected:
  void expect_no_other_profile(const std::string& whole, const std::string& name) const {
    const fs::path file = folder.path() / name;
    write_file(file, whole);
    const GaugeReading right = take(file).reading;
    for (int percent = 0; percent < 100; ++percent) {
      SCOPED_TRACE(percent);
      const std::size_t bytes = whole.size() * static_cast<std::size_t>(percent) / 100;
      write_file(file, whole.substr(0, bytes));
      try {
        const GaugeReading read = take(file).reading;
        EXPECT_NEAR(*read.lifter_height, *right.lifter_height, 1e-4);
        EXPECT_NEAR(*read.plate_thickness, *right.plate_thickness, 1e-3);
        EXPECT_NEAR(leading_face_angle(*read.profile), leading_face_angle(*right.profile), 1e-3);
        ++taken;
      } catch (const InputError&) {
      }
    }
  }
  mutable int taken = 0;
};

TEST_F(CutOffFile, OfAGaugeIsNotTakenForAnotherProfile) {
  expect_no_other_profile(read_file(inputs / "plus_signs.csv"), "cut.csv");
}

TEST_F(CutOffFile, OfTheProgramIsRefused) {
  expect_no_other_profile(profile_csv(*take(inputs / "plus_signs.csv").reading.profile), "cut.csv");
  EXPECT_EQ(taken, 0);
}

TEST_F(CutOffFile, OfADrawingIsRefused) {
  const fs::path drawing = folder.path() / "whole.dxf";
  meshgen::write_dxf_polyline(take(inputs / "plus_signs.csv").reading.profile->nodes, "LINER",
                              drawing);
  expect_no_other_profile(read_file(drawing), "cut.dxf");
  EXPECT_EQ(taken, 0);
}

}  // namespace
}  // namespace millwear::orchestrator
