#include "orchestrator/pictures/charge_spheres.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "orchestrator/pictures/colour_ramp.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector3d;

/// From the largest to the smallest particles of a material.
struct Shades {
  Rgb dark;
  Rgb bright;
};
const std::vector<Shades> material_shades{{{0.10, 0.24, 0.42}, {0.55, 0.74, 0.90}},
                                          {{0.42, 0.25, 0.13}, {0.90, 0.78, 0.58}},
                                          {{0.20, 0.36, 0.22}, {0.68, 0.82, 0.62}},
                                          {{0.36, 0.20, 0.40}, {0.80, 0.68, 0.84}}};

}  // namespace

std::vector<ColouredName> class_colours(const std::vector<ShownClass>& classes) {
  std::map<std::string, std::vector<double>> sizes;
  std::vector<std::string> materials;
  for (const ShownClass& one : classes) {
    if (!sizes.contains(one.material)) materials.push_back(one.material);
    sizes[one.material].push_back(one.diameter);
  }
  std::vector<ColouredName> colours;
  for (const ShownClass& one : classes) {
    const auto material = std::ranges::find(materials, one.material) - materials.begin();
    const Shades& shades =
        material_shades[static_cast<std::size_t>(material) % material_shades.size()];
    const auto [least, most] = std::ranges::minmax(sizes.at(one.material));
    const double share =
        most > least ? std::log(most / one.diameter) / std::log(most / least) : 0.5;
    colours.push_back({one.name, (1.0 - share) * shades.dark + share * shades.bright});
  }
  return colours;
}

std::vector<Sphere> spheres_of(const wear::ChargeFrames& frames, std::size_t frame,
                               Colouring colouring, const std::vector<ColouredName>& classes,
                               double fastest) {
  constexpr double shades = 63.0;
  std::vector<Sphere> spheres;
  for (std::size_t i = 0; i < frames.particles(); ++i) {
    const auto kind = frames.classes[i];
    const double share = std::min(frames.speed_of(frame, i) / fastest, 1.0);
    spheres.push_back({frames.place(frame, i), frames.class_radius[kind],
                       colouring == Colouring::size
                           ? classes[kind].colour
                           : ramp_colour(std::round(share * shades) / shades)});
  }
  return spheres;
}

}  // namespace millwear::orchestrator
