#include "meshgen/dxf_polyline.h"

#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "mill/base/constants.h"
#include "mill/base/failure.h"

namespace millwear::meshgen {
namespace {

constexpr int insert_units_millimetres = 4;

void write_tables(DL_Dxf& dxf, DL_WriterA& writer, const std::string& layer) {
  writer.sectionTables();
  dxf.writeVPort(writer);
  writer.tableLinetypes(3);
  for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"}) {
    dxf.writeLinetype(writer, DL_LinetypeData(name, name, 0, 0, 0.0));
  }
  writer.tableEnd();
  writer.tableLayers(2);
  const DL_Attributes solid("", 7, 0x000000, 25, "CONTINUOUS");
  dxf.writeLayer(writer, DL_LayerData("0", 0), solid);
  dxf.writeLayer(writer, DL_LayerData(layer, 0), solid);
  writer.tableEnd();
  writer.tableStyle(1);
  dxf.writeStyle(writer, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  writer.tableEnd();
  dxf.writeView(writer);
  dxf.writeUcs(writer);
  writer.tableAppid(1);
  dxf.writeAppid(writer, "ACAD");
  writer.tableEnd();
  dxf.writeDimStyle(writer, 1, 1, 1, 1, 1);
  dxf.writeBlockRecord(writer);
  writer.tableEnd();
  writer.sectionEnd();
}

void write_blocks(DL_Dxf& dxf, DL_WriterA& writer) {
  writer.sectionBlocks();
  for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(writer, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(writer, name);
  }
  writer.sectionEnd();
}

/// Metres in a unit of $INSUNITS (1 inches, 2 feet, 4 mm, 5 cm, 6 m).
std::optional<double> metres_per_insert_unit(int unit) {
  switch (unit) {
    case 1:
      return 0.0254;
    case 2:
      return 0.3048;
    case insert_units_millimetres:
      return 1e-3;
    case 5:
      return 1e-2;
    case 6:
      return 1.0;
    default:
      return std::nullopt;
  }
}

/// Adds the arc from `from` to `to`, without `from`; `bulge` is the tangent of a quarter of its
/// angle, > 0 where it runs counter-clockwise.
void add_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge,
             std::vector<Eigen::Vector2d>& nodes) {
  const double angle = 4.0 * std::atan(bulge);
  const int chords = static_cast<int>(std::ceil(std::abs(angle) * 180.0 / std::numbers::pi));
  const Eigen::Vector2d half = 0.5 * (to - from);
  const Eigen::Vector2d left(-half.y(), half.x());
  const Eigen::Vector2d centre = from + half + left * (1.0 - bulge * bulge) / (2.0 * bulge);
  for (int i = 1; i < chords; ++i) {
    const double turn = angle * i / chords;
    const Eigen::Vector2d arm = from - centre;
    nodes.emplace_back(centre.x() + std::cos(turn) * arm.x() - std::sin(turn) * arm.y(),
                       centre.y() + std::sin(turn) * arm.x() + std::cos(turn) * arm.y());
  }
  nodes.push_back(to);
}

class PolylineReader : public DL_CreationAdapter {
 public:
  void setVariableInt(const std::string& key, int value, int) override {
    if (key == "$INSUNITS") drawing.metres_per_unit = metres_per_insert_unit(value);
  }
  void addPolyline(const DL_PolylineData& polyline) override {
    constexpr int closed_flag = 1;
    drawing.polylines.push_back(
        {getAttributes().getLayer(), (polyline.flags & closed_flag) != 0, {}});
    bulge_ = 0.0;
  }
  void addVertex(const DL_VertexData& vertex) override {
    if (drawing.polylines.empty()) return;
    auto& nodes = drawing.polylines.back().nodes;
    const Eigen::Vector2d node(vertex.x, vertex.y);
    if (!nodes.empty() && bulge_ != 0.0)
      add_arc(Eigen::Vector2d(nodes.back()), node, bulge_, nodes);
    else
      nodes.push_back(node);
    bulge_ = vertex.bulge;
  }
  DxfDrawing drawing{};

 private:
  double bulge_ = 0.0;
};

}  // namespace

void write_dxf_polyline(const std::vector<Eigen::Vector2d>& nodes, const std::string& layer,
                        const std::filesystem::path& path) {
  DL_Dxf dxf;
  const std::unique_ptr<DL_WriterA> writer(dxf.out(path.c_str(), DL_Codes::AC1015));
  if (!writer) {
    throw DiskError(fmt::format("{}: cannot be written", path.string()));
  }
  dxf.writeHeader(*writer);
  writer->dxfString(9, "$INSUNITS");
  writer->dxfInt(70, insert_units_millimetres);
  writer->sectionEnd();
  write_tables(dxf, *writer, layer);
  write_blocks(dxf, *writer);
  writer->sectionEntities();
  const DL_Attributes on_layer(layer, 256, -1, "BYLAYER", 1.0);
  dxf.writePolyline(*writer, DL_PolylineData(static_cast<int>(nodes.size()), 0, 0, 0), on_layer);
  for (const Eigen::Vector2d& node : nodes) {
    dxf.writeVertex(
        *writer, DL_VertexData(node.x() * millimetres_per_metre, node.y() * millimetres_per_metre));
  }
  dxf.writePolylineEnd(*writer);
  writer->sectionEnd();
  dxf.writeObjects(*writer);
  dxf.writeObjectsEnd(*writer);
  writer->dxfEOF();
  writer->close();
}

DxfDrawing read_dxf_drawing(const std::filesystem::path& path) {
  DL_Dxf dxf;
  PolylineReader reader;
  if (!dxf.in(path.string(), &reader)) {
    throw DiskError(fmt::format("{}: cannot be read", path.string()));
  }
  return std::move(reader.drawing);
}

std::vector<Eigen::Vector2d> read_dxf_polyline(const std::string& layer,
                                               const std::filesystem::path& path) {
  std::vector<Eigen::Vector2d> nodes;
  for (const DxfPolyline& polyline : read_dxf_drawing(path).polylines) {
    if (polyline.layer != layer) continue;
    for (const Eigen::Vector2d& node : polyline.nodes) {
      nodes.emplace_back(node / millimetres_per_metre);
    }
  }
  return nodes;
}

}  // namespace millwear::meshgen
