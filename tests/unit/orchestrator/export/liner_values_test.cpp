#include "orchestrator/export/liner_values.h"

#include <gmock/gmock.h>

#include "orchestrator/export/liner_surface.h"
#include "tests/support/sample_profiles.h"

namespace millwear::orchestrator {
namespace {

using testing::Each;
using testing::FloatNear;
using wear::bare_ring;
using wear::square_lifter;

constexpr int bins = 50;

const std::vector<float>& floats(const VtkArray& array) {
  return std::get<std::vector<float>>(array.numbers);
}

const std::vector<float>& named(const std::vector<VtkArray>& arrays, const std::string& name) {
  for (const auto& array : arrays)
    if (array.name == name) return floats(array);
  throw std::runtime_error("no array " + name);
}

/// A load that grows along the DEM's liner: its bins have 0, 1, 2, ...
LoadAlongProfile rising_load() {
  LoadAlongProfile load{};
  for (int bin = 0; bin < bins; ++bin) {
    load.arc_length.push_back(bin + 0.5);
    load.contacts.raw.push_back(3.0 * bin);
    load.normal_dissipation.raw.push_back(2.0 * bin);
    load.sliding_work.raw.push_back(bin);
    load.depth_rate.smoothed.push_back(1e-12 * bin);
  }
  return load;
}

// A ring whose radius grew by 3 mm has lost 3 mm everywhere.
TEST(WearDepth, IsTheDistanceFromTheNewLiner) {
  const LinerProfile fresh = bare_ring(1.0, 400);
  const wear::ProfileIndex index(fresh, 0.1);
  EXPECT_THAT(floats(wear_depth(bare_ring(1.003, 400), index)), Each(FloatNear(0.003F, 1e-5F)));
  EXPECT_THAT(floats(wear_depth(fresh, index)), Each(FloatNear(0.0F, 1e-7F)));
}

// 1e-12 m/s are 3.6e-3 mm in 1000 h.
TEST(LoadValues, OfTheMeasuredLinerAreTheBins) {
  const LinerProfile liner = square_lifter();
  const auto arrays = load_values({liner, Rotation::as_new, rising_load()}, liner);
  const auto segments = bins_of_segments(cut_at_bins(liner, bins), bins);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto bin = static_cast<float>(segments[i]);
    EXPECT_FLOAT_EQ(named(arrays, "sliding_work_w_per_m2")[i], bin);
    EXPECT_FLOAT_EQ(named(arrays, "normal_dissipation_w_per_m2")[i], 2.0F * bin);
    EXPECT_FLOAT_EQ(named(arrays, "contacts_per_m")[i], 3.0F * bin);
    EXPECT_NEAR(named(arrays, "wear_rate_mm_per_1000_h")[i], 3.6e-3F * bin, 1e-6F);
  }
}

// The DEM of a reversed mill ran on the mirror image.
TEST(LoadValues, OfAReversedMillRunBackwards) {
  const LinerProfile liner = square_lifter();
  const auto arrays = load_values({liner, Rotation::reversed, rising_load()}, liner);
  const auto segments = bins_of_segments(cut_at_bins(liner, bins), bins);
  for (std::size_t i = 0; i < segments.size(); ++i)
    EXPECT_NEAR(named(arrays, "sliding_work_w_per_m2")[i],
                static_cast<float>(bins - 1 - segments[i]), 1e-4F);
}

// All of a ring wears from where it lay on the same radius.
TEST(LoadValues, GoWithThePlacesThatWear) {
  const LinerProfile fresh = bare_ring(1.0, bins);
  const LinerProfile worn = bare_ring(1.003, bins);
  const auto arrays = load_values({fresh, Rotation::as_new, rising_load()}, worn);
  const auto segments = bins_of_segments(cut_at_bins(worn, bins), bins);
  for (std::size_t i = 1; i + 1 < segments.size(); ++i)
    EXPECT_NEAR(named(arrays, "sliding_work_w_per_m2")[i], static_cast<float>(segments[i]), 0.1F);
}

}  // namespace
}  // namespace millwear::orchestrator
