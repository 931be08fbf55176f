#pragma once
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "mill/liner/liner_profile.h"
#include "mill/liner/parametric_lifter.h"

namespace millwear::meshgen::test {

constexpr double degree = M_PI / 180.0;

/// A laboratory mill of 1 m: 12 lifters of 40 mm, balls of 30 mm.
inline LinerProfile laboratory_liner() {
  return profile_of({0.52, 0.50, 12}, {0.040, 0.030, 20.0 * degree, 20.0 * degree});
}

/// A mill of 8 m: 52 lifters of 215 mm, smallest particles 22 mm.
inline LinerProfile production_liner() {
  return profile_of({4.06, 4.0, 52}, {0.215, 0.100, 15.0 * degree, 10.0 * degree});
}

/// A bare plate over one pitch, its circle cut into `segments` chords.
inline LinerProfile bare_plate(double radius, int rows, int segments) {
  LinerProfile profile{{1.05 * radius, radius, rows}, {}};
  for (int i = 0; i <= segments; ++i) {
    const double angle = profile.sector.pitch() * (static_cast<double>(i) / segments - 0.5);
    profile.nodes.push_back(point_at(profile.sector, radius, angle));
  }
  return profile;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of its own for one test, removed when the test ends.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "millwear_mesh_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace millwear::meshgen::test
