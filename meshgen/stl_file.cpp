#include "meshgen/stl_file.h"

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "meshgen/gmsh_kernel.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"

namespace millwear::meshgen {
namespace {

/// Sixteen digits read back to within this share of the value.
constexpr double text_precision = 1e-15;

class StlReader {
 public:
  explicit StlReader(const std::filesystem::path& path) : path_(path), stream_(path) {
    if (!stream_) {
      throw DiskError(fmt::format("{}: cannot be read", path.string()));
    }
  }

  std::vector<StlFacet> facets() {
    expect("solid");
    std::string rest_of_line;
    std::getline(stream_, rest_of_line);
    std::vector<StlFacet> result;
    while (next_word("facet or endsolid") == "facet") {
      result.push_back(facet());
    }
    if (word_ != "endsolid") {
      refuse("`endsolid`");
    }
    return result;
  }

 private:
  StlFacet facet() {
    expect("normal");
    vector();
    expect("outer");
    expect("loop");
    StlFacet corners;
    for (Eigen::Vector3d& corner : corners) {
      expect("vertex");
      corner = vector();
    }
    expect("endloop");
    expect("endfacet");
    return corners;
  }

  Eigen::Vector3d vector() {
    Eigen::Vector3d result;
    if (!(stream_ >> result.x() >> result.y() >> result.z()) || !result.allFinite()) {
      refuse("three numbers");
    }
    return result;
  }

  const std::string& next_word(const char* wanted) {
    if (!(stream_ >> word_)) {
      word_ = "its end";
      refuse(wanted);
    }
    return word_;
  }

  void expect(const char* wanted) {
    if (next_word(wanted) != wanted) {
      refuse(wanted);
    }
  }

  [[noreturn]] void refuse(const char* wanted) const {
    throw ResultRejected(fmt::format("{}: incomplete or not ASCII STL: {} wanted, found {}",
                                     path_.string(), wanted, word_));
  }

  std::filesystem::path path_;
  std::ifstream stream_;
  std::string word_;
};

void compare(const Triangulation& mesh, const std::filesystem::path& path) {
  const auto facets = read_stl(path);
  if (facets.size() != mesh.triangles.size()) {
    throw ResultRejected(fmt::format("{}: holds {} of {} triangles; is the disk full?",
                                     path.string(), facets.size(), mesh.triangles.size()));
  }
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3d& vertex = mesh.vertices[mesh.triangles[i][corner]];
      const double error = (facets[i][corner] - vertex).cwiseAbs().maxCoeff();
      if (!(error <= text_precision * vertex.cwiseAbs().maxCoeff())) {
        throw ResultRejected(fmt::format("{}: triangle {} reads back {:.3g} m from where it lies",
                                         path.string(), i, error));
      }
    }
  }
}

}  // namespace

void write_stl(const Triangulation& mesh, const std::filesystem::path& path) {
  publish_written(path, [&](const std::filesystem::path& beside) {
    write_ascii_stl(mesh, beside);
    compare(mesh, beside);
  });
}

std::vector<StlFacet> read_stl(const std::filesystem::path& path) {
  return StlReader(path).facets();
}

}  // namespace millwear::meshgen
