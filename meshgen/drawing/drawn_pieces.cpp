#include "meshgen/drawing/drawn_pieces.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <charconv>
#include <cmath>
#include <memory>

#include "mill/base/failure.h"

namespace millwear::meshgen {
namespace {

namespace fs = std::filesystem;

/// Flat to this share of a curve's size.
constexpr double flat = 1e-6;

/// A text as a file of GDAL's, while this lives.
class FileInMemory {
 public:
  explicit FileInMemory(const std::string& text)
      : path_(fmt::format("/vsimem/{:p}.dxf", fmt::ptr(this))) {
    VSILFILE* const file = VSIFOpenL(path_.c_str(), "wb");
    VSIFWriteL(text.data(), 1, text.size(), file);
    VSIFCloseL(file);
  }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  ~FileInMemory() { VSIUnlink(path_.c_str()); }

  [[nodiscard]] const char* path() const { return path_.c_str(); }

 private:
  std::string path_;
};

/// GDAL's settings and silence, while this lives.
class DxfReading {
 public:
  DxfReading() {
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLSetThreadLocalConfigOption("OGR_ARC_STEPSIZE", "1");
    CPLSetThreadLocalConfigOption("DXF_MERGE_BLOCK_GEOMETRIES", "FALSE");
    CPLSetThreadLocalConfigOption("DXF_INLINE_BLOCKS", "TRUE");
  }
  DxfReading(const DxfReading&) = delete;
  DxfReading& operator=(const DxfReading&) = delete;
  ~DxfReading() {
    for (const char* const option :
         {"OGR_ARC_STEPSIZE", "DXF_MERGE_BLOCK_GEOMETRIES", "DXF_INLINE_BLOCKS"})
      CPLSetThreadLocalConfigOption(option, nullptr);
    CPLPopErrorHandler();
  }
};

int line_of(const OGRFeature& feature) {
  const std::string handle = feature.GetFieldAsString("EntityHandle");
  int line = 0;
  std::from_chars(handle.data(), handle.data() + handle.size(), line);
  return line;
}

void add_line(const OGRLineString& drawn, const DrawnPiece& described, const fs::path& file,
              std::vector<DrawnPiece>& pieces) {
  DrawnPiece piece = described;
  OGREnvelope3D box;
  drawn.getEnvelope(&box);
  if (box.MaxZ - box.MinZ > flat * (box.MaxX - box.MinX + box.MaxY - box.MinY))
    throw InputError(
        fmt::format("{}:{}: the curve is not flat (z from {:g} to {:g}); draw the "
                    "profile in the plane of x and y",
                    file.string(), piece.line, box.MinZ, box.MaxZ));
  for (int i = 0; i < drawn.getNumPoints(); ++i) {
    const Eigen::Vector2d node(drawn.getX(i), drawn.getY(i));
    if (!node.allFinite())
      throw InputError(fmt::format("{}:{}: a place of the curve is no number; mend the drawing",
                                   file.string(), piece.line));
    if (piece.nodes.empty() || piece.nodes.back() != node) piece.nodes.push_back(node);
  }
  if (piece.nodes.size() > 1) pieces.push_back(std::move(piece));
}

void add_geometry(const OGRGeometry& geometry, const DrawnPiece& described, const fs::path& file,
                  std::vector<DrawnPiece>& pieces) {
  if (wkbFlatten(geometry.getGeometryType()) == wkbLineString) {
    add_line(*geometry.toLineString(), described, file, pieces);
  } else if (const auto type = wkbFlatten(geometry.getGeometryType());
             type == wkbMultiLineString || type == wkbGeometryCollection) {
    for (const OGRGeometry* const part : *geometry.toGeometryCollection())
      add_geometry(*part, described, file, pieces);
  } else if (type == wkbPolygon) {
    for (const OGRLinearRing* const ring : *geometry.toPolygon())
      add_line(*ring, described, file, pieces);
  }
}

}  // namespace

std::vector<DrawnPiece> drawn_pieces(const std::string& text, const fs::path& file) {
  const DxfReading settings;
  const FileInMemory memory(text);
  const char* const drivers[] = {"DXF", nullptr};
  const std::unique_ptr<GDALDataset> drawing(
      GDALDataset::Open(memory.path(), GDAL_OF_VECTOR, drivers));
  if (!drawing)
    throw InputError(
        fmt::format("{}: the drawing cannot be read: {}", file.string(), CPLGetLastErrorMsg()));
  std::vector<DrawnPiece> pieces;
  for (OGRLayer* const entities : drawing->GetLayers()) {
    CPLErrorReset();
    for (const auto& feature : *entities) {
      const OGRGeometry* const geometry = feature->GetGeometryRef();
      if (geometry == nullptr) continue;
      add_geometry(*geometry, {feature->GetFieldAsString("Layer"), line_of(*feature), {}}, file,
                   pieces);
    }
    if (CPLGetLastErrorType() >= CE_Failure)
      throw InputError(
          fmt::format("{}: the drawing cannot be read: {}", file.string(), CPLGetLastErrorMsg()));
  }
  return pieces;
}

std::string utf8_of(const std::string& word, const std::string& code_page) {
  const DxfReading settings;
  const std::unique_ptr<char, decltype(&VSIFree)> recoded(
      CPLRecode(word.c_str(), code_page.c_str(), CPL_ENC_UTF8), &VSIFree);
  return recoded.get();
}

}  // namespace millwear::meshgen
