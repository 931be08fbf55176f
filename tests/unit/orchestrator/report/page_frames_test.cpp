#include "orchestrator/report/page_frames.h"

#include <gtest/gtest.h>

#include <cmath>

namespace millwear::orchestrator {
namespace {

constexpr std::size_t count = 3;

/// Five frames of three particles: one flies by 0.1 m a frame, one creeps, one leaves the slice at
/// its far end and comes back at the near one.
wear::ChargeFrames sample_frames() {
  wear::ChargeFrames frames{
      .across = {-1.0, 1.0}, .along = {0.0, 0.25}, .speed = {0.0, 10.0}, .thinning = 1};
  frames.class_radius = {0.03, 0.02};
  frames.classes = {1, 0, 1};
  for (int f = 0; f < 5; ++f) {
    frames.times.push_back(0.01 * f);
    frames.mill_angles.push_back(0.02 * f);
    for (const double x : {-0.5 + 0.1 * f, 0.3 + 0.0007 * f, 0.0})
      frames.places.push_back(frames.across.packed(x));
    for (const double y : {0.1, 0.1, std::fmod(0.22 + 0.02 * f, 0.25)})
      frames.places.push_back(frames.along.packed(y));
    for (const double z : {0.0, -0.2, 0.1 * f}) frames.places.push_back(frames.across.packed(z));
  }
  return frames;
}

/// Where the page puts a particle in a frame.
double place(const PageFrames& page, const wear::FrameRange& range, std::size_t frame,
             std::size_t axis, std::size_t particle, std::size_t particles = count) {
  double at = range.unpacked(page.first[axis * particles + particle]);
  std::int8_t move = 0;
  for (std::size_t f = 0; f < frame; ++f) {
    move = static_cast<std::int8_t>(move + page.changes[(3 * f + axis) * particles + particle]);
    at += page.step * move;
  }
  return at;
}

TEST(PageFrames, MovesBringEveryParticleWhereItIsWithoutDrift) {
  const auto frames = sample_frames();
  const PageFrames page = page_frames(frames, 1, 1'000'000);
  EXPECT_EQ(page.thinning, 1U);
  EXPECT_EQ(page.times.size(), 5U);
  EXPECT_NEAR(page.step, 0.1 / 127, 1e-6) << "the longest move has 127 steps";
  for (std::size_t f = 0; f < 5; ++f) {
    const double frame = static_cast<double>(f);
    EXPECT_NEAR(place(page, frames.across, f, 0, 0), -0.5 + 0.1 * frame, 0.51 * page.step);
    EXPECT_NEAR(place(page, frames.across, f, 0, 1), 0.3 + 0.0007 * frame, 0.51 * page.step);
    EXPECT_NEAR(place(page, frames.across, f, 2, 2), 0.1 * frame, 0.51 * page.step);
  }
}

TEST(PageFrames, AParticleThatLeavesTheSliceGoesOnPastItsEnd) {
  const auto frames = sample_frames();
  const PageFrames page = page_frames(frames, 1, 1'000'000);
  EXPECT_NEAR(place(page, frames.along, 4, 1, 2), 0.30, 0.51 * page.step);
}

TEST(PageFrames, EverySecondFrameSpansTheSameTime) {
  const auto frames = sample_frames();
  const PageFrames page = page_frames(frames, 2, 1'000'000);
  EXPECT_EQ(page.times, (std::vector{0.0, 0.02, 0.04}));
  EXPECT_EQ(page.mill_angles, (std::vector{0.0, 0.04, 0.08}));
  EXPECT_NEAR(place(page, frames.across, 2, 0, 0), -0.1, 0.51 * page.step);
}

// With five frames a particle takes 16 bytes: 40 have room for two, so every second is kept.
TEST(PageFrames, ThinWhereTheRoomIsNotEnough) {
  const auto frames = sample_frames();
  const PageFrames page = page_frames(frames, 1, 40);
  EXPECT_EQ(page.thinning, 2U);
  EXPECT_EQ(page.classes, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_NEAR(place(page, frames.across, 4, 2, 1, 2), 0.4, 0.51 * page.step);
}

}  // namespace
}  // namespace millwear::orchestrator
