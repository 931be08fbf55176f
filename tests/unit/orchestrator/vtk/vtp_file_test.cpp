#include "orchestrator/vtk/vtp_file.h"

#include <gmock/gmock.h>

#include "tests/support/vtp_reader.h"

namespace millwear::orchestrator {
namespace {

using testing::ElementsAre;

/// A unit square, a vertex at its first corner, an array of every kind.
VtkPolyData square() {
  VtkPolyData data;
  data.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  data.vertices.add({0});
  data.polygons.add({0, 1, 2, 3});
  data.point_data = {{"class", 1, std::vector<std::uint8_t>{1, 2, 3, 255}},
                     {"velocity", 3, std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}};
  data.cell_data = {{"depth", 1, std::vector<float>{0.5F, 0.25F}}};
  data.field_data = {{"hours", 1, std::vector<double>{0.1}}};
  return data;
}

TEST(VtpFile, SaysHowItsBytesAreToBeRead) {
  const ReadVtp read = read_vtp(vtp_file(square()));
  EXPECT_EQ(read.head.at("type"), "PolyData");
  EXPECT_EQ(read.head.at("version"), "1.0");
  EXPECT_EQ(read.head.at("byte_order"), "LittleEndian");
  EXPECT_EQ(read.head.at("header_type"), "UInt64");
  EXPECT_FALSE(read.head.contains("compressor"));
}

TEST(VtpFile, HasAsManyPointsAndCellsAsItSays) {
  const ReadVtp read = read_vtp(vtp_file(square()));
  EXPECT_EQ(read.piece.at("NumberOfPoints"), "4");
  EXPECT_EQ(read.piece.at("NumberOfVerts"), "1");
  EXPECT_EQ(read.piece.at("NumberOfPolys"), "1");
  EXPECT_THAT(read["Points/Points"], ElementsAre(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0));
  EXPECT_THAT(read["Verts/connectivity"], ElementsAre(0));
  EXPECT_THAT(read["Verts/offsets"], ElementsAre(1));
  EXPECT_THAT(read["Polys/connectivity"], ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(read["Polys/offsets"], ElementsAre(4));
}

TEST(VtpFile, KeepsEveryArrayToTheBit) {
  const ReadVtp read = read_vtp(vtp_file(square()));
  EXPECT_THAT(read["PointData/class"], ElementsAre(1, 2, 3, 255));
  EXPECT_EQ(read.arrays.at("PointData/velocity").components, 3);
  EXPECT_THAT(read["PointData/velocity"], ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
  EXPECT_THAT(read["CellData/depth"], ElementsAre(0.5, 0.25));
  EXPECT_EQ(read.arrays.at("FieldData/hours").type, "Float64");
  EXPECT_THAT(read["FieldData/hours"], ElementsAre(0.1));
}

TEST(VtpFile, TakesNoArrayThatMissesANumber) {
  VtkPolyData data = square();
  data.cell_data[0].numbers = std::vector<float>{0.5F};
  EXPECT_THROW(static_cast<void>(vtp_file(data)), std::logic_error);
}

}  // namespace
}  // namespace millwear::orchestrator
