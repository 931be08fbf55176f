#include "orchestrator/export/charge_particles.h"

#include <array>
#include <utility>

#include "mill/base/contract.h"

namespace millwear::orchestrator {
namespace {

/// Signs of x, y and z.
using Signs = std::array<float, 3>;

struct Mirror {
  Signs vector;  ///< of places and velocities
  Signs spin;    ///< of what turns about an axis
};

Mirror mirror_of(Rotation rotation) {
  if (rotation == Rotation::as_new) return {{1.0F, 1.0F, 1.0F}, {1.0F, 1.0F, 1.0F}};
  return {{-1.0F, 1.0F, 1.0F}, {1.0F, -1.0F, -1.0F}};
}

/// Three rows of the state, by particle: row `first` of x, and those of y and z after it.
std::vector<float> vectors(const wear::ChargeFrames& frames, std::size_t first,
                           const Signs& signs) {
  std::vector<float> values;
  for (std::size_t i = 0; i < frames.particles(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      values.push_back(signs[axis] * frames.state[(first + axis) * frames.particles() + i]);
  return values;
}

std::vector<float> unpacked_places(const wear::ChargeFrames& frames, std::size_t frame,
                                   const Signs& signs) {
  std::vector<float> values;
  for (std::size_t i = 0; i < frames.particles(); ++i) {
    const Eigen::Vector3f place = frames.place(frame, i).cast<float>();
    for (std::size_t axis = 0; axis < 3; ++axis) values.push_back(signs[axis] * place[axis]);
  }
  return values;
}

}  // namespace

VtkPolyData charge_particles(const wear::ChargeFrames& frames, std::size_t frame,
                             Rotation rotation) {
  expect(frame < frames.frames(), "there is such a frame");
  const Mirror mirror = mirror_of(rotation);
  VtkPolyData charge;
  charge.points = frame == 0 ? vectors(frames, 0, mirror.vector)
                             : unpacked_places(frames, frame, mirror.vector);
  std::vector<std::int32_t> numbers;
  std::vector<float> diameters;
  std::vector<float> speeds;
  for (std::size_t i = 0; i < frames.particles(); ++i) {
    charge.vertices.add({static_cast<std::int32_t>(i)});
    numbers.push_back(static_cast<std::int32_t>(1 + i * frames.thinning));
    diameters.push_back(static_cast<float>(2.0 * frames.class_radius[frames.classes[i]]));
    speeds.push_back(static_cast<float>(frames.speed_of(frame, i)));
  }
  charge.point_data = {{"diameter_m", 1, std::move(diameters)},
                       {"speed_m_per_s", 1, std::move(speeds)},
                       {"class", 1, frames.classes},
                       {"particle", 1, std::move(numbers)}};
  if (frame == 0) {
    charge.point_data.push_back({"velocity_m_per_s", 3, vectors(frames, 3, mirror.vector)});
    charge.point_data.push_back({"spin_rad_per_s", 3, vectors(frames, 6, mirror.spin)});
  }
  return charge;
}

}  // namespace millwear::orchestrator
