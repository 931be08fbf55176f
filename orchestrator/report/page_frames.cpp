#include "orchestrator/report/page_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace millwear::orchestrator {
namespace {

using wear::ChargeFrames;

constexpr std::size_t axes = 3;
constexpr std::size_t along_axis = 1;
constexpr double most_move = std::numeric_limits<std::int8_t>::max();

double moved(const ChargeFrames& frames, std::size_t axis, double from, double to) {
  const double length = frames.along.high - frames.along.low;
  return axis == along_axis ? std::remainder(to - from, length) : to - from;
}

/// The kept particles' numbers, and the frames'.
struct Kept {
  std::vector<std::size_t> particles;
  std::vector<std::size_t> frames;
};

std::vector<std::size_t> each(std::size_t step, std::size_t end) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < end; i += step) numbers.push_back(i);
  return numbers;
}

double longest_move(const ChargeFrames& frames, const Kept& kept) {
  double longest = 0.0;
  for (std::size_t f = 1; f < kept.frames.size(); ++f)
    for (std::size_t axis = 0; axis < axes; ++axis)
      for (const std::size_t i : kept.particles)
        longest = std::max(longest,
                           std::abs(moved(frames, axis, frames.place(kept.frames[f - 1], i)[axis],
                                          frames.place(kept.frames[f], i)[axis])));
  return longest;
}

/// The moves of one particle along one axis, into `page`.
void add_moves(const ChargeFrames& frames, const Kept& kept, std::size_t axis, std::size_t column,
               PageFrames& page) {
  const std::size_t count = kept.particles.size();
  const std::size_t particle = kept.particles[column];
  double there = frames.place(kept.frames[0], particle)[axis];
  for (std::size_t f = 1; f < kept.frames.size(); ++f) {
    const double way = moved(frames, axis, there, frames.place(kept.frames[f], particle)[axis]);
    const double steps = std::clamp(std::round(way / page.step), -most_move, most_move);
    page.changes[(axes * (f - 1) + axis) * count + column] = static_cast<std::int8_t>(steps);
    there += steps * page.step;
  }
}

/// Moves become what they change by from frame to frame.
void to_changes(std::vector<std::int8_t>& moves, std::size_t row_size) {
  for (std::size_t i = moves.size(); i-- > row_size;)
    moves[i] = static_cast<std::int8_t>(moves[i] - moves[i - row_size]);
}

}  // namespace

PageFrames page_frames(const ChargeFrames& frames, std::size_t every, std::size_t most_bytes) {
  Kept kept{.particles = {}, .frames = each(every, frames.frames())};
  const std::size_t particle_bytes = 1 + axes * (1 + kept.frames.size());
  const std::size_t thinning = 1 + (frames.particles() * particle_bytes - 1) / most_bytes;
  kept.particles = each(thinning, frames.particles());
  const std::size_t count = kept.particles.size();
  PageFrames page{.thinning = frames.thinning * thinning,
                  .times = {},
                  .mill_angles = {},
                  .step = std::max(longest_move(frames, kept) / most_move, 1e-6),
                  .classes = {},
                  .first = {},
                  .changes = std::vector<std::int8_t>(axes * (kept.frames.size() - 1) * count)};
  for (const std::size_t f : kept.frames) {
    page.times.push_back(frames.times[f]);
    page.mill_angles.push_back(frames.mill_angles[f]);
  }
  for (const std::size_t i : kept.particles) page.classes.push_back(frames.classes[i]);
  for (std::size_t axis = 0; axis < axes; ++axis)
    for (std::size_t column = 0; column < count; ++column) {
      const std::size_t in_first = (axes * kept.frames[0] + axis) * frames.particles();
      page.first.push_back(frames.places[in_first + kept.particles[column]]);
      add_moves(frames, kept, axis, column, page);
    }
  to_changes(page.changes, axes * count);
  return page;
}

}  // namespace millwear::orchestrator
