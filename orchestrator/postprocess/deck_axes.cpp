#include "orchestrator/postprocess/deck_axes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

Eigen::Vector3d axis_of(std::string_view word) {
  const bool is_signed = !word.empty() && (word.front() == '+' || word.front() == '-');
  const std::string_view letter = is_signed ? word.substr(1) : word;
  if (letter != "x" && letter != "y" && letter != "z")
    throw InputError(
        fmt::format("\"{}\" is no axis; it is one of +x, -x, +y, -y, +z and -z", word));
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(letter.front() - 'x');
  return word.front() == '-' ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace

Eigen::Matrix3d axes_to_mill(std::string_view turns_about, std::string_view gravity) {
  const Eigen::Vector3d y = axis_of(turns_about);
  const Eigen::Vector3d z = -axis_of(gravity);
  if (y.dot(z) != 0.0)
    throw InputError(fmt::format(
        "the mill turns about {} and gravity is along {}; the mill's axis has to be level",
        turns_about, gravity));
  Eigen::Matrix3d rows;
  rows << y.cross(z).transpose(), y.transpose(), z.transpose();
  return rows;
}

}  // namespace millwear::orchestrator
