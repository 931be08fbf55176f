#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace millwear {

/// One particle touching the liner at one instant.
struct WallContact {
  Eigen::Vector3d point;       ///< [m], mill frame
  double normal_force;         ///< Fn [N], positive pushes; damping can pull as a contact ends
  double slip_speed;           ///< |v_slip| of the surfaces with the particle's spin [m/s]
  double normal_speed;         ///< closing speed of the surfaces [m/s], positive on approach
  std::size_t particle_class;  ///< index into Charge::classes
  std::size_t triangle;        ///< order of the STL file
};

/// Every wall contact of one instant.
struct WallContacts {
  double time;        ///< since the measurement began [s]
  double mill_angle;  ///< since the stretch began [rad]
  std::vector<WallContact> contacts;
};

}  // namespace millwear
