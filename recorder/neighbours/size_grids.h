#pragma once
#include <array>
#include <span>
#include <vector>

namespace millwear::recorder {

/// Centres [m], as LIGGGHTS keeps them, and radii [m] of spheres 0 to n - 1.
struct Spheres {
  const double* const* centres;
  std::span<const double> radii;
};

using Place = std::array<double, 3>;  ///< [m]

/// When two spheres count as neighbours: |x_i - x_j| <= (r_i + r_j) stretch + skin.
struct NeighbourReach {
  double skin;           ///< [m]
  double stretch = 1.0;  ///< >= 1
};

/// Spheres of many sizes, sorted into one grid of cells for every octave of radii. A sphere looks
/// for small neighbours in small cells near its surface and for large ones in large cells, so that
/// few large spheres among many small ones do not make the search of the small ones wider. A
/// hierarchical grid: Krijgsman, Ogarko and Luding (2014), Comput. Part. Mech. 1, 357.
class SizeGrids {
 public:
  /// Radii have to be positive, centres finite. `spheres` have to stay where they are for
  /// `add_later_neighbours`.
  SizeGrids(const Spheres& spheres, const NeighbourReach& reach);

  /// Appends every neighbour j > `sphere` to `neighbours`, in no order to rely on.
  void add_later_neighbours(int sphere, std::vector<int>& neighbours) const;

  /// Appends every sphere whose centre lies within `growth` times r stretch + skin of the box from
  /// `low` to `high`, axis by axis, and some that do not, in no order to rely on. Where `low` is
  /// above `high` by more than both ends reach, there are none.
  void add_spheres_near(const Place& low, const Place& high, const Place& growth,
                        std::vector<int>& spheres) const;

 private:
  struct Entry {
    double x, y, z, radius;
    int number;
  };
  struct Grid {
    double largest_radius;
    double cell;  ///< edge [m]
    Place origin;
    std::array<int, 3> cells;
    std::vector<int> first;  ///< entry of each cell, x fastest, and the end
    std::vector<Entry> entries;
  };

  [[nodiscard]] Grid grid_of(const std::vector<int>& members) const;

  /// Hands every entry to `take` whose cell is within `far` of the box, axis by axis, in rows that
  /// lie in one piece.
  template <class Take>
  static void for_each_row(const Grid& grid, const Place& low, const Place& high, const Place& far,
                           Take take);

  Spheres spheres_;
  NeighbourReach reach_;
  std::vector<Grid> grids_;
};

}  // namespace millwear::recorder
