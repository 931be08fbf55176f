#include "tests/verification/wear/random_liners.h"

#include <rapidcheck.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

#include "wear/record/profile_index.h"

namespace millwear::wear {
namespace {

namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
using Points = std::vector<Eigen::Vector2d>;

/// A place by its share of the pitch from the lifter's centre, -1/2 ... 1/2, and its height over
/// the new plate as a share of the pitch's arc.
using Shape = std::vector<Eigen::Vector2d>;

LinerSector random_sector() {
  const int rows = *rc::gen::inRange(4, 41);
  const double radius = between(20, 600, 1e-2);
  const double arc = 2.0 * radius * M_PI / rows;
  return {radius + std::min(0.3 * arc, 0.1 * radius), radius, rows};
}

Shape trapezoid() {
  const double top = between(2, 20, 1e-2);
  const double foot = top + between(0, 20, 1e-2);
  const double height = between(1, 25, 1e-2);
  const double nose = between(0, 8, 1e-2);
  return {{-foot, 0.0}, {-top, height}, {0.0, height + nose}, {top, height}, {foot, 0.0}};
}

Shape fin() {
  const double half = between(5, 20, 1e-3);
  const double height = between(10, 30, 1e-2);
  return {{-0.2, 0.0}, {-half, 0.03}, {-half, height}, {half, height}, {half, 0.03}, {0.2, 0.0}};
}

Shape waves() {
  Shape shape;
  const int places = *rc::gen::inRange(1, 20);
  for (int i = 0; i < places; ++i)
    shape.emplace_back((i + 1.0) / (places + 1.0) - 0.5, between(-3, 4, 1e-2));
  return shape;
}

Shape cap_on_a_stem() {
  const double stem = between(3, 12, 1e-2);
  const double cap = stem + between(1, 8, 1e-2);
  const double under = between(4, 12, 1e-2);
  const double height = under + between(2, 10, 1e-2);
  return {{-stem, 0.0},  {-stem, under}, {-cap, under}, {-cap, height},
          {cap, height}, {cap, under},   {stem, under}, {stem, 0.0}};
}

Shape leaning() {
  const double height = between(5, 20, 1e-2);
  const double lean = between(1, 10, 1e-2);
  return {{-0.15, 0.0}, {-0.1 + lean, height}, {0.1 + lean, height}, {0.1, 0.0}};
}

Shape two_lifters() {
  const double high = between(5, 20, 1e-2);
  const double low = between(2, 12, 1e-2);
  return {{-0.4, 0.0}, {-0.35, low}, {-0.2, low}, {-0.15, 0.0},
          {0.05, 0.0}, {0.1, high},  {0.3, high}, {0.35, 0.0}};
}

LinerProfile liner_of(const Shape& shape) {
  const LinerSector sector = random_sector();
  const double arc = sector.plate_radius * sector.pitch();
  const double lowest = -0.5 * (sector.shell_radius - sector.plate_radius);
  const double level = *rc::gen::inRange(0, 3) == 0 ? lowest * between(0, 100, 1e-2) : 0.0;
  const double highest = 0.6 * sector.plate_radius;
  LinerProfile profile{sector, {}};
  const auto add = [&](double share, double height) {
    const double eta = std::clamp(level + height * arc, lowest, highest);
    profile.nodes.push_back(point_at(sector, sector.plate_radius - eta, share * sector.pitch()));
  };
  add(-0.5, 0.0);
  for (const auto& place : shape) add(place.x(), place.y());
  add(0.5, 0.0);
  return profile;
}

BoostPolygon steel(const LinerProfile& profile) {
  BoostPolygon polygon;
  const auto add = [&](const Eigen::Vector2d& place) {
    bg::append(polygon, bg::make<bg::model::d2::point_xy<double>>(place.x(), place.y()));
  };
  const LinerSector& sector = profile.sector;
  for (const auto& node : profile.nodes) add(node);
  const double first = angle_of(sector, profile.nodes.front());
  const double outside = 2.0 * sector.shell_radius;
  for (int i = 8; i >= 0; --i) add(point_at(sector, outside, first + sector.pitch() * i / 8.0));
  bg::correct(polygon);
  return polygon;
}

}  // namespace

double between(int low, int high, double unit) { return *rc::gen::inRange(low, high) * unit; }

LinerProfile random_upright_liner() {
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      return liner_of(trapezoid());
    case 1:
      return liner_of(fin());
    case 2:
      return liner_of(waves());
    default:
      return liner_of(two_lifters());
  }
}

LinerProfile random_liner() {
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return liner_of(cap_on_a_stem());
    case 1:
      return liner_of(leaning());
    default:
      return random_upright_liner();
  }
}

ArcCurve random_load(const LinerProfile& profile, Eigen::Index bins) {
  ArcCurve load{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
                Eigen::VectorXd::Zero(bins)};
  const auto any_bin = [&] { return *rc::gen::inRange<Eigen::Index>(0, bins); };
  switch (*rc::gen::inRange(0, 5)) {
    case 0: {
      for (double& rate : load.values) rate = between(1, 100, 1e-2);
      const auto unloaded = *rc::gen::inRange<Eigen::Index>(0, bins - 10);
      const auto size = *rc::gen::inRange<Eigen::Index>(0, bins - unloaded - 5);
      load.values.segment(unloaded, size).setZero();
      break;
    }
    case 1:
      load.values[any_bin()] = 1.0;
      break;
    case 2: {
      const auto centre = static_cast<double>(any_bin());
      const double width = between(5, 100, 1e-1);
      for (Eigen::Index i = 0; i < bins; ++i)
        load.values[i] = 0.05 + std::exp(-std::pow((static_cast<double>(i) - centre) / width, 2));
      break;
    }
    case 3: {
      const auto from = any_bin();
      load.values.segment(from, std::min(bins / 2, bins - from)).setOnes();
      break;
    }
    default:
      for (int spot = 0; spot < 6; ++spot) load.values[any_bin()] = between(1, 100, 1e-2);
  }
  return load;
}

MovedProfile worn_by(const LinerProfile& profile, const ArcCurve& load, double area) {
  const auto nodes = loss_nodes(profile, load.bin_width(), [&](double s) { return load.at(s); });
  return move_profile(profile, nodes, area, load.bin_width());
}

double gained(const LinerProfile& before, const LinerProfile& after) {
  std::vector<BoostPolygon> gain;
  bg::difference(steel(after), steel(before), gain);
  double area = 0.0;
  for (const auto& piece : gain) area += std::abs(bg::area(piece));
  return area;
}

double distance_between(const LinerProfile& first, const LinerProfile& second) {
  double greatest = 0.0;
  const auto compare = [&](const LinerProfile& nodes_of, const LinerProfile& line) {
    const ProfileIndex index(line, 0.0);
    for (const auto& node : nodes_of.nodes)
      greatest = std::max(greatest, index.nearest(node).distance);
  };
  compare(first, second);
  compare(second, first);
  return greatest;
}

LinerProfile started_at(const LinerProfile& profile, std::size_t start) {
  LinerProfile result{profile.sector, {}};
  result.nodes.assign(profile.nodes.begin() + static_cast<std::ptrdiff_t>(start),
                      profile.nodes.end() - 1);
  for (std::size_t i = 0; i <= start; ++i)
    result.nodes.push_back(shifted_by_pitches(profile.sector, profile.nodes[i], 1));
  return result;
}

}  // namespace millwear::wear
