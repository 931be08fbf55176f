#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace millwear::wear {

/// What the 16 bits of a frame stand for: 0 ... 65535 from the low end of a range to its high end.
struct FrameRange {
  double low;
  double high;

  /// The nearest of the 65536 values; what lies outside counts as the end.
  [[nodiscard]] std::uint16_t packed(double value) const;
  [[nodiscard]] double unpacked(std::uint16_t value) const;
  bool operator==(const FrameRange&) const = default;
};

/// A short sequence of pictures of the charge, smooth enough to draw tracks, and its state in full
/// at the first of them. Of a large charge every `thinning`-th particle is kept. Arrays by particle
/// run fastest.
struct ChargeFrames {
  FrameRange across;  ///< of x and z [m], mill frame
  FrameRange along;   ///< of y [m]
  FrameRange speed;   ///< [m/s]
  std::size_t thinning;
  std::vector<double> times = {};  ///< of the frames, from the first [s]
  std::vector<double> mill_angles =
      {};  ///< by which the liner has turned since the mesh was made [rad]
  std::vector<double> class_radius = {};   ///< by particle class [m]
  std::vector<std::uint8_t> classes = {};  ///< by particle
  std::vector<std::uint16_t> places = {};  ///< frames x (x, y, z) x particles
  std::vector<std::uint16_t> speeds = {};  ///< frames x particles
  std::vector<float> state = {};  ///< (x y z, vx vy vz, wx wy wz) x particles [m, m/s, rad/s]

  [[nodiscard]] std::size_t particles() const { return classes.size(); }
  [[nodiscard]] std::size_t frames() const { return times.size(); }
  /// Where a particle is in a frame [m], in the mill frame.
  [[nodiscard]] Eigen::Vector3d place(std::size_t frame, std::size_t particle) const;
  /// Its speed there [m/s].
  [[nodiscard]] double speed_of(std::size_t frame, std::size_t particle) const;
};

/// Values of a frame's row as differences to those of the row before, modulo 65536: small numbers,
/// which compress well.
void to_differences(std::vector<std::uint16_t>& rows, std::size_t row_size);
/// And back.
void from_differences(std::vector<std::uint16_t>& rows, std::size_t row_size);

}  // namespace millwear::wear
