#pragma once
#include <Eigen/Core>
#include <vector>

namespace millwear::orchestrator {

/// Shares of red, green and blue, 0 ... 1.
using Rgb = Eigen::Vector3d;

struct Sphere {
  Eigen::Vector3d centre;  ///< [m]
  double radius;           ///< [m]
  Rgb colour;
};

struct Triangle {
  Eigen::Vector3d corners[3];  ///< [m]
  Rgb colour;
};

enum class Projection { orthographic, perspective };

/// Looks from `eye` along `direction`.
struct Camera {
  Projection projection;
  Eigen::Vector3d eye;        ///< [m]
  Eigen::Vector3d direction;  ///< of any length
  Eigen::Vector3d up;         ///< what is drawn upwards
  double height;              ///< of what is seen [m]; in perspective at a distance of |direction|
};

/// What a picture shows, in the mill frame (right-handed).
struct Scene {
  Camera camera;
  Eigen::Vector3d light;  ///< the way it shines
  std::vector<Sphere> spheres;
  std::vector<Triangle> triangles;
};

}  // namespace millwear::orchestrator
