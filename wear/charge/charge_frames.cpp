#include "wear/charge/charge_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace millwear::wear {
namespace {

constexpr double steps = std::numeric_limits<std::uint16_t>::max();

}  // namespace

std::uint16_t FrameRange::packed(double value) const {
  const double share = (value - low) / (high - low);
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * steps));
}

double FrameRange::unpacked(std::uint16_t value) const {
  return low + (high - low) * (value / steps);
}

Eigen::Vector3d ChargeFrames::place(std::size_t frame, std::size_t particle) const {
  const auto packed = [&](std::size_t axis) {
    return places[(3 * frame + axis) * particles() + particle];
  };
  return {across.unpacked(packed(0)), along.unpacked(packed(1)), across.unpacked(packed(2))};
}

double ChargeFrames::speed_of(std::size_t frame, std::size_t particle) const {
  return speed.unpacked(speeds[frame * particles() + particle]);
}

void to_differences(std::vector<std::uint16_t>& rows, std::size_t row_size) {
  for (std::size_t i = rows.size(); i-- > row_size;)
    rows[i] = static_cast<std::uint16_t>(rows[i] - rows[i - row_size]);
}

void from_differences(std::vector<std::uint16_t>& rows, std::size_t row_size) {
  for (std::size_t i = row_size; i < rows.size(); ++i)
    rows[i] = static_cast<std::uint16_t>(rows[i] + rows[i - row_size]);
}

}  // namespace millwear::wear
