#include "meshgen/drawing/dxf_polyline.h"

#include <dl_dxf.h>
#include <fmt/format.h>

#include <memory>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/base/length_unit.h"

namespace millwear::meshgen {
namespace {

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
  writer->dxfInt(70, name_of(LengthUnit::millimetre).insert_units);
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

}  // namespace millwear::meshgen
