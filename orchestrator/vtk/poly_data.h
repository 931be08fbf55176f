#pragma once
#include <cstdint>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

namespace millwear::orchestrator {

/// Numbers of an array, in the type that the file has them in.
using VtkNumbers = std::variant<std::vector<std::uint8_t>, std::vector<std::int32_t>,
                                std::vector<float>, std::vector<double>>;

/// An array with a name: `components` numbers a point or a cell, one after the other.
struct VtkArray {
  std::string name;
  int components;
  VtkNumbers numbers;
};

/// Cells of one kind: the points of all cells one after the other, and where the points of each
/// cell end among them.
struct VtkCells {
  std::vector<std::int32_t> connectivity{};
  std::vector<std::int32_t> offsets{};

  /// Adds a cell with these points.
  void add(std::initializer_list<std::int32_t> points) {
    connectivity.insert(connectivity.end(), points);
    offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
  }
};

/// Points and cells with what is known of them, VTK's `vtkPolyData`. Cell data have the vertices
/// first, then the polygons.
struct VtkPolyData {
  std::vector<float> points{};  ///< x, y, z of each [m]
  VtkCells vertices{};
  VtkCells polygons{};
  std::vector<VtkArray> point_data{};
  std::vector<VtkArray> cell_data{};
  std::vector<VtkArray> field_data{};  ///< of the whole
};

}  // namespace millwear::orchestrator
