#include "orchestrator/pictures/charge_views.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "orchestrator/pictures/composed.h"
#include "orchestrator/pictures/liner_section.h"
#include "orchestrator/pictures/tachyon.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const Vector3d light(0.45, 1.0, -0.8);
const Rgb steel_colour(0.36, 0.40, 0.44);

double shell_radius(const ChargeAtInstant& charge) { return charge.liner.sector.shell_radius; }

double mill_angle(const ChargeAtInstant& charge) { return charge.frames.mill_angles[charge.frame]; }

std::vector<Sphere> spheres(const ChargeAtInstant& charge) {
  return spheres_of(charge.frames, charge.frame, charge.colouring, charge.classes, charge.fastest);
}

PlotParts legend(const ChargeAtInstant& charge) {
  return charge.colouring == Colouring::speed ? colour_bar(charge.fastest, "speed [m/s]")
                                              : colour_names(charge.classes);
}

/// Looks along the axis at a window of the section.
Camera along_the_axis(const ChargeAtInstant& charge, const PictureWindow& window) {
  const Vector2d middle = 0.5 * (window.low + window.high);
  return {.projection = Projection::orthographic,
          .eye = {middle.x(), -shell_radius(charge), middle.y()},
          .direction = {0.0, 1.0, 0.0},
          .up = {0.0, 0.0, 1.0},
          .height = window.size().y()};
}

/// Those that can be seen in a window.
std::vector<Sphere> inside(std::vector<Sphere> all, const PictureWindow& window) {
  std::erase_if(all, [&](const Sphere& sphere) {
    const Vector2d place(sphere.centre.x(), sphere.centre.z());
    return (place.array() + sphere.radius < window.low.array()).any() ||
           (place.array() - sphere.radius > window.high.array()).any();
  });
  return all;
}

/// The steel is drawn over the spheres: along the axis it hides nothing of them but the overlap of
/// the contacts.
ChargePicture with_steel(const ChargeAtInstant& charge, const PictureWindow& window,
                         const PictureSize& size) {
  const Scene scene{along_the_axis(charge, window), light, inside(spheres(charge), window), {}};
  return composed(rendered(scene, size), window,
                  filled(steel_outlines(charge.liner, mill_angle(charge)), steel_colour),
                  scale_bar(window) + legend(charge));
}

}  // namespace

ChargePicture section_picture(const ChargeAtInstant& charge) {
  const Vector2d corner = Vector2d::Constant(1.01 * shell_radius(charge));
  return with_steel(charge, {-corner, corner}, {1440, 1440});
}

ChargePicture close_up_picture(const ChargeAtInstant& charge) {
  constexpr double pitches = 3.5;
  constexpr double angle = 75.0 / 180.0 * std::numbers::pi;  // from six o'clock along the rotation
  const double radius = shell_radius(charge);
  const double side =
      std::clamp(pitches * charge.liner.sector.pitch() * radius, 0.25 * radius, radius);
  const Vector2d middle = -(radius - 0.45 * side) * Vector2d(std::sin(angle), std::cos(angle));
  const Vector2d half = Vector2d::Constant(0.5 * side);
  return with_steel(charge, {middle - half, middle + half}, {1260, 1260});
}

ChargePicture slice_picture(const ChargeAtInstant& charge) {
  const PictureSize size{1680, 1410};
  const double radius = shell_radius(charge);
  const double length = charge.frames.along.high - charge.frames.along.low;
  const Vector3d eye = radius * Vector3d(1.6, -4.2, 1.0);
  const Vector3d middle(0.0, 0.5 * length, 0.0);
  const Scene scene{{.projection = Projection::perspective,
                     .eye = eye,
                     .direction = middle - eye,
                     .up = {0.0, 0.0, 1.0},
                     .height = 2.1 * radius},
                    light,
                    spheres(charge),
                    cut_liner(charge.liner, mill_angle(charge), length)};
  return composed(rendered(scene, size), {{0.0, 0.0}, {size.width, size.height}}, {},
                  legend(charge));
}

}  // namespace millwear::orchestrator
