#include "orchestrator/pictures/tachyon.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <map>

#include "mill/base/failure.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/memory_file.h"

namespace millwear::orchestrator {
namespace {

using Eigen::Vector3d;

constexpr int colour_steps = 255;

std::string written(const Vector3d& place) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", -place.x(), place.y(), place.z());
}

/// Names the textures of a scene, one a colour.
class Textures {
 public:
  std::string name_of(const Rgb& colour) {
    std::array<int, 3> key;
    for (int i = 0; i < 3; ++i) key[i] = static_cast<int>(std::lround(colour[i] * colour_steps));
    return fmt::format("c{}", names_.try_emplace(key, names_.size()).first->second);
  }

  [[nodiscard]] std::string definitions() const {
    std::string text;
    for (const auto& [key, number] : names_)
      fmt::format_to(std::back_inserter(text),
                     "TEXDEF c{} AMBIENT 0.3 DIFFUSE 0.8 SPECULAR 0 OPACITY 1 "
                     "PHONG PLASTIC 0.15 PHONG_SIZE 25 COLOR {} {} {} TEXFUNC 0\n",
                     number, static_cast<double>(key[0]) / colour_steps,
                     static_cast<double>(key[1]) / colour_steps,
                     static_cast<double>(key[2]) / colour_steps);
    return text;
  }

 private:
  std::map<std::array<int, 3>, std::size_t> names_;
};

std::string camera_text(const Camera& camera) {
  const double distance =
      camera.projection == Projection::orthographic ? 1.0 : camera.direction.norm();
  return fmt::format(
      "CAMERA\nPROJECTION {}\nZOOM {:.6g}\nASPECTRATIO 1\nANTIALIASING 0\nRAYDEPTH 4\n"
      "CENTER {}\nVIEWDIR {}\nUPDIR {}\nEND_CAMERA\n",
      camera.projection == Projection::orthographic ? "ORTHOGRAPHIC" : "PERSPECTIVE",
      distance / camera.height, written(camera.eye), written(camera.direction.normalized()),
      written(camera.up));
}

}  // namespace

std::string tachyon_scene(const Scene& scene, const PictureSize& size) {
  Textures textures;
  std::string objects;
  const auto out = std::back_inserter(objects);
  for (const Sphere& sphere : scene.spheres)
    fmt::format_to(out, "SPHERE CENTER {} RAD {:.6g} {}\n", written(sphere.centre), sphere.radius,
                   textures.name_of(sphere.colour));
  for (const auto& [corners, colour] : scene.triangles)
    fmt::format_to(out, "TRI V0 {} V1 {} V2 {} {}\n", written(corners[0]), written(corners[1]),
                   written(corners[2]), textures.name_of(colour));
  return fmt::format("BEGIN_SCENE\nRESOLUTION {} {}\n", size.width, size.height) +
         camera_text(scene.camera) +
         fmt::format("DIRECTIONAL_LIGHT DIRECTION {} COLOR 1 1 1\nBACKGROUND 1 1 1\n",
                     written(scene.light.normalized())) +
         textures.definitions() + objects + "END_SCENE\n";
}

Image rendered(const Scene& scene, const PictureSize& size) {
  const std::string subject = "a picture of the charge";
  const MemoryFile nothing(subject);
  const MemoryFile model(subject, tachyon_scene(scene, size));
  const MemoryFile picture(subject);
  const MemoryFile messages(subject);
  ChildProcess tachyon(
      {program_on_path("tachyon", "tachyon-bin-nox").string(), model.path().string(), "-numthreads",
       "1", "-format", "PPM", "-o", picture.path().string(), "-auto_skylight", "0.5",
       "-skylight_samples", "3"},
      std::filesystem::current_path(),
      ChildFiles{nothing.descriptor(), messages.descriptor(), messages.descriptor()});
  if (const int code = tachyon.wait(); code != 0)
    throw ExternalProgramError(
        fmt::format("tachyon failed (exit code {}): {}", code, messages.content()));
  return image_from_ppm(picture.content());
}

}  // namespace millwear::orchestrator
