#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "mill/base/failure.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_measures.h"
#include "tests/verification/wear/random_liners.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 100;

/// A section to wear off in one step [m2], between 10^low and 10^high of the steel of a pitch.
double random_section(const LinerProfile& profile, int low, int high) {
  return steel_area(profile) * std::pow(10.0, between(100 * low, 100 * high, 1e-2));
}

/// The rounding of a section [m2].
double rounding(const LinerSector& sector) {
  return 1e-14 * 0.5 * sector.pitch() * std::pow(sector.shell_radius, 2);
}

/// What must hold whatever the profile and the load.
void check_step(const LinerProfile& before, const MovedProfile& worn, double area) {
  const LinerProfile& after = worn.profile;
  RC_ASSERT(first_crossing(after) == std::pair(-1, -1));
  const double lost = steel_area(before) - steel_area(after);
  RC_ASSERT(std::abs(lost - worn.dropped_area - area) <=
            1e-9 * (area + worn.dropped_area) + 1.1 * rounding(before.sector));
  RC_ASSERT(lost == worn.removed_area);
  RC_ASSERT(gained(before, after) <= 3e-9 * arc_lengths(before).back());
  const auto& sector = before.sector;
  RC_ASSERT(std::abs(radius_of(sector, after.nodes.front()) -
                     radius_of(sector, after.nodes.back())) < 1e-14 * sector.plate_radius);
  RC_ASSERT(std::abs(angle_of(sector, after.nodes.front()) -
                     angle_of(sector, before.nodes.front())) < 1e-13);
}

RC_GTEST_PROP(RandomWear, NoCrossingNoGainPeriodicAndExact, ()) {
  LinerProfile profile = random_liner();
  for (int step = 0; step < 4; ++step) {
    const double area = random_section(profile, -6, -2);
    const auto worn = worn_by(profile, random_load(profile, bins), area);
    check_step(profile, worn, area);
    profile = worn.profile;
  }
}

/// A step of `area`, or where that is refused of its half, its quarter ... as an evolution takes
/// it.
MovedProfile worn_by_at_most(const LinerProfile& profile, const ArcCurve& load, double area) {
  for (int halvings = 0;; ++halvings) {
    try {
      return worn_by(profile, load, area);
    } catch (const ResultRejected&) {
      if (halvings == 4) throw;
      area *= 0.5;
    }
  }
}

// Up to 24 steps of a thousandth of a pitch's steel each.
RC_GTEST_PROP(RandomWear, ManyStepsStayValidAndTheNodesFew, ()) {
  LinerProfile profile = random_liner();
  const double area = 1e-3 * steel_area(profile);
  const int steps = *rc::gen::inRange(1, 25);
  for (int step = 0; step < steps; ++step) {
    const auto worn = worn_by_at_most(profile, random_load(profile, 50), area);
    RC_ASSERT(worn.profile.nodes.size() < 600U);
    profile = worn.profile;
  }
}

/// How far two ways to the same surface may lie apart [m]: thinning, which goes from one end to the
/// other, joins nodes closer than a twentieth of a bin and may keep another one of them, on each
/// side.
double surfaces_within(const ArcCurve& load) { return 0.1 * load.bin_width() + 2e-6; }

RC_GTEST_PROP(RandomWear, MirroredLoadWearsTheMirroredProfile, ()) {
  const LinerProfile profile = random_liner();
  const auto load = random_load(profile, bins);
  const ArcCurve mirrored_load{load.bin_edges, load.values.reverse()};
  const double area = random_section(profile, -6, -2);
  const auto here = worn_by(profile, load, area);
  const auto there = worn_by(mirrored(profile), mirrored_load, area);
  RC_ASSERT(std::abs(there.dropped_area - here.dropped_area) <= 1e-6 * (area + here.dropped_area));
  RC_ASSERT(distance_between(here.profile, mirrored(there.profile)) < surfaces_within(load));
}

// A shape is a ring around the mill; where the pitch begins is ours to say.
RC_GTEST_PROP(RandomWear, StartsAnywhereOnThePitch, ()) {
  const LinerProfile profile = random_upright_liner();
  const auto load = random_load(profile, bins);
  const double area = random_section(profile, -6, -2);
  const auto start = *rc::gen::inRange<std::size_t>(0, profile.nodes.size() - 1);
  const LinerProfile other = started_at(profile, start);
  const double start_at = arc_lengths(profile)[start];
  const auto other_loss =
      loss_nodes(other, load.bin_width(), [&](double s) { return load.at(s + start_at); });
  const auto here = worn_by(profile, load, area);
  const auto there = move_profile(other, other_loss, area, load.bin_width());
  RC_ASSERT(std::abs(there.dropped_area - here.dropped_area) <= 1e-6 * (area + here.dropped_area));
  RC_ASSERT(distance_between(here.profile, there.profile) < surfaces_within(load));
}

// Where the rate is zero for more than a bin around, the surface is the old one, exactly.
RC_GTEST_PROP(RandomWear, UnloadedNodesStay, ()) {
  const LinerProfile profile = random_upright_liner();
  const auto load = random_load(profile, bins);
  const auto worn = worn_by(profile, load, random_section(profile, -6, -4)).profile;
  const auto lengths = arc_lengths(profile);
  for (std::size_t i = 1; i + 1 < profile.nodes.size(); ++i) {
    double rate_around = 0.0;
    for (int bin = -3; bin <= 3; ++bin) rate_around += load.at(lengths[i] + bin * load.bin_width());
    if (rate_around > 0.0) continue;
    RC_ASSERT(std::find(worn.nodes.begin(), worn.nodes.end(), profile.nodes[i]) !=
              worn.nodes.end());
  }
}

}  // namespace
}  // namespace millwear::wear
