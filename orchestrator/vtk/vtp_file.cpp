#include "orchestrator/vtk/vtp_file.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "mill/base/contract.h"

namespace millwear::orchestrator {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says it is little-endian");

const char* type_name(const std::vector<std::uint8_t>&) { return "UInt8"; }
const char* type_name(const std::vector<std::int32_t>&) { return "Int32"; }
const char* type_name(const std::vector<float>&) { return "Float32"; }
const char* type_name(const std::vector<double>&) { return "Float64"; }

std::size_t count_of(const VtkArray& array) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, array.numbers);
}

/// The two parts of a file as they grow: the XML, and the bytes that it points to.
class VtpWriter {
 public:
  void line(const std::string& text) { xml_ += text + "\n"; }

  template <class T>
  void array(const std::string& attributes, const std::vector<T>& numbers) {
    line(fmt::format(R"(        <DataArray type="{}" {} format="appended" offset="{}"/>)",
                     type_name(numbers), attributes, appended_.size()));
    const std::uint64_t bytes = numbers.size() * sizeof(T);
    append(&bytes, sizeof bytes);
    append(numbers.data(), bytes);
  }

  void array(const VtkArray& array_of, const std::string& more = "") {
    const std::string attributes = fmt::format(R"(Name="{}" NumberOfComponents="{}"{})",
                                               array_of.name, array_of.components, more);
    std::visit([&](const auto& numbers) { array(attributes, numbers); }, array_of.numbers);
  }

  void data(const char* element, const std::vector<VtkArray>& arrays, std::size_t tuples) {
    line(fmt::format("      <{}>", element));
    for (const auto& values : arrays) {
      expect(count_of(values) == tuples * static_cast<std::size_t>(values.components),
             "an array has its components for every point or cell");
      array(values);
    }
    line(fmt::format("      </{}>", element));
  }

  void cells(const char* element, const VtkCells& cells) {
    line(fmt::format("      <{}>", element));
    array(R"(Name="connectivity")", cells.connectivity);
    array(R"(Name="offsets")", cells.offsets);
    line(fmt::format("      </{}>", element));
  }

  [[nodiscard]] std::string file() const {
    return xml_ + "  <AppendedData encoding=\"raw\">\n   _" + appended_ +
           "\n  </AppendedData>\n</VTKFile>\n";
  }

 private:
  void append(const void* bytes, std::size_t count) {
    appended_.append(static_cast<const char*>(bytes), count);
  }

  std::string xml_;
  std::string appended_;
};

}  // namespace

std::string vtp_file(const VtkPolyData& data) {
  const std::size_t points = data.points.size() / 3;
  const std::size_t vertices = data.vertices.offsets.size();
  const std::size_t polygons = data.polygons.offsets.size();
  VtpWriter writer;
  writer.line(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <PolyData>");
  writer.line("    <FieldData>");
  for (const auto& values : data.field_data)
    writer.array(values,
                 fmt::format(R"( NumberOfTuples="{}")",
                             count_of(values) / static_cast<std::size_t>(values.components)));
  writer.line("    </FieldData>");
  writer.line(fmt::format(R"(    <Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="0" )"
                          R"(NumberOfStrips="0" NumberOfPolys="{}">)",
                          points, vertices, polygons));
  writer.data("PointData", data.point_data, points);
  writer.data("CellData", data.cell_data, vertices + polygons);
  writer.line("      <Points>");
  writer.array(R"(Name="Points" NumberOfComponents="3")", data.points);
  writer.line("      </Points>");
  writer.cells("Verts", data.vertices);
  writer.cells("Polys", data.polygons);
  writer.line("    </Piece>\n  </PolyData>");
  return writer.file();
}

}  // namespace millwear::orchestrator
