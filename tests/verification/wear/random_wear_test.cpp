#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

#include "sample_profiles.h"
#include "wear/arc_curve.h"
#include "wear/profile_motion.h"

namespace millwear::wear {
namespace {

namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>>;

constexpr Eigen::Index bins = 100;

double between(int low, int high, double unit) { return *rc::gen::inRange(low, high) * unit; }

/// A lifter with random height, widths, a nose and a random plate level.
LinerProfile random_profile() {
  const double half = 0.5 * sample_sector.pitch();
  const double foot = between(60, 150, 1e-3);
  const double top = between(20, 60, 1e-3);
  const double height = between(5, 160, 1e-3);
  const double level = between(-30, 1, 1e-3);
  const double nose = between(0, 40, 1e-3);
  return {sample_sector,
          {point_at(sample_sector, 1.0 - level, -half),
           {-foot, level},
           {-top, level + height},
           {0.0, level + height + nose},
           {top, level + height},
           {foot, level},
           point_at(sample_sector, 1.0 - level, half)}};
}

/// Random smooth-ish rates with stretches of no load.
ArcCurve random_rates(const LinerProfile& profile) {
  ArcCurve curve{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
                 Eigen::VectorXd::Zero(bins)};
  for (double& rate : curve.values) rate = between(1, 100, 1e-2);
  const auto unloaded = *rc::gen::inRange<Eigen::Index>(0, bins - 10);
  const auto size = *rc::gen::inRange<Eigen::Index>(0, bins - unloaded - 5);
  curve.values.segment(unloaded, size).setZero();
  return curve;
}

MovedProfile worn_by(const LinerProfile& profile, const ArcCurve& curve, double area) {
  const auto nodes = loss_nodes(profile, curve.bin_width(), [&](double s) { return curve.at(s); });
  return move_profile(profile, nodes, area, curve.bin_width());
}

BoostPolygon steel(const LinerProfile& profile) {
  BoostPolygon polygon;
  for (const auto& node : profile.nodes)
    bg::append(polygon, bg::make<bg::model::d2::point_xy<double>>(node.x(), node.y()));
  const double angle = 0.5 * sample_sector.pitch();
  for (const double end : {angle, -angle}) {
    const auto corner = point_at(sample_sector, 1.5, end);
    bg::append(polygon, bg::make<bg::model::d2::point_xy<double>>(corner.x(), corner.y()));
  }
  bg::correct(polygon);
  return polygon;
}

double gained(const LinerProfile& before, const LinerProfile& after) {
  std::vector<BoostPolygon> gain;
  bg::difference(steel(after), steel(before), gain);
  double area = 0.0;
  for (const auto& piece : gain) area += std::abs(bg::area(piece));
  return area;
}

RC_GTEST_PROP(RandomWear, NoCrossingNoGainPeriodicAndExact, ()) {
  LinerProfile profile = random_profile();
  for (int step = 0; step < 6; ++step) {
    const auto curve = random_rates(profile);
    const double area = between(1, 100, 2e-6);
    const auto worn = worn_by(profile, curve, area);
    RC_ASSERT(first_crossing(worn.profile) == std::pair(-1, -1));
    RC_ASSERT(std::abs(steel_area(profile) - steel_area(worn.profile) - area) <= 1e-9 * area);
    const double length = arc_lengths(profile).back();
    RC_ASSERT(gained(profile, worn.profile) <= 3e-9 * length);
    const auto& nodes = worn.profile.nodes;
    RC_ASSERT(std::abs(radius_of(sample_sector, nodes.front()) -
                       radius_of(sample_sector, nodes.back())) < 1e-13);
    profile = worn.profile;
  }
}

RC_GTEST_PROP(RandomWear, MirroredLoadWearsTheMirroredProfile, ()) {
  const LinerProfile profile = random_profile();
  const auto curve = random_rates(profile);
  const ArcCurve mirrored_curve{curve.bin_edges, curve.values.reverse()};
  const double area = between(1, 100, 2e-6);
  const auto here = worn_by(profile, curve, area).profile;
  const auto there = mirrored(worn_by(mirrored(profile), mirrored_curve, area).profile);
  RC_ASSERT(std::abs(lifter_height(here) - lifter_height(there)) < 2e-6);
  const double either = gained(here, there) + gained(there, here);
  RC_ASSERT(either < 5e-3 * area + 2e-6 * arc_lengths(profile).back());
}

// Where the rate is zero for more than a bin around, the surface is the old one, exactly.
RC_GTEST_PROP(RandomWear, UnloadedNodesStay, ()) {
  const LinerProfile profile = random_profile();
  const auto curve = random_rates(profile);
  const auto worn = worn_by(profile, curve, between(1, 100, 1e-6)).profile;
  const auto lengths = arc_lengths(profile);
  for (std::size_t i = 1; i + 1 < profile.nodes.size(); ++i) {
    const double w = curve.bin_width();
    const bool unloaded = curve.at(lengths[i] - 3 * w) + curve.at(lengths[i] - 2 * w) +
                              curve.at(lengths[i] - w) + curve.at(lengths[i]) +
                              curve.at(lengths[i] + w) + curve.at(lengths[i] + 2 * w) +
                              curve.at(lengths[i] + 3 * w) ==
                          0.0;
    if (!unloaded) continue;
    RC_ASSERT(std::find(worn.nodes.begin(), worn.nodes.end(), profile.nodes[i]) !=
              worn.nodes.end());
  }
}

}  // namespace
}  // namespace millwear::wear
