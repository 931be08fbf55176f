#include "tests/verification/wear/closed_form_campaign.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/sample_profiles.h"
#include "wear/evolve/evolution.h"

namespace millwear::wear {
namespace {

constexpr Eigen::Index bins = 120;
constexpr double day = 86400.0;

ArcCurve rate_on(const LinerProfile& profile, const ClosedFormLoad& load) {
  ArcCurve curve{Eigen::VectorXd::LinSpaced(bins + 1, 0.0, arc_lengths(profile).back()),
                 Eigen::VectorXd(bins)};
  for (Eigen::Index i = 0; i < bins; ++i) {
    curve.values[i] = load.rate(profile, (static_cast<double>(i) + 0.5) * curve.bin_width());
  }
  return curve;
}

double mean_radius(const LinerProfile& profile) {
  double sum = 0.0;
  for (const auto& node : profile.nodes) sum += radius_of(profile.sector, node);
  return sum / static_cast<double>(profile.nodes.size());
}

ClosedFormLoad ring(std::string name, double growth) {
  constexpr double rate = 1e-9;
  constexpr double duration = 100.0 * day;
  const double depth =
      growth > 0.0 ? std::expm1(growth * rate * duration) / growth : rate * duration;
  const LinerProfile fresh = bare_ring(1.0, 120);
  return {std::move(name),
          fresh,
          duration,
          depth * arc_lengths(fresh).back(),
          0.05,
          0.005,
          [=](const LinerProfile& profile, double) {
            return rate * (1.0 + growth * (mean_radius(profile) - mean_radius(fresh)));
          },
          [=](const LinerProfile& worn) {
            return std::abs(mean_radius(worn) - mean_radius(fresh) - depth) / depth;
          }};
}

constexpr double top_radius = 0.12;
constexpr double top_half_angle = 1.2;
constexpr double compared_within = 0.5;
const Eigen::Vector2d top_centre(0.0, 0.05);

/// A round top on a flat plate, in facets of half a degree.
LinerProfile round_lifter() {
  const double half = 0.5 * sample_sector.pitch();
  LinerProfile profile{sample_sector, {point_at(sample_sector, 1.0, -half)}};
  constexpr int facets = 280;
  for (int i = 0; i <= facets; ++i) {
    const double angle = top_half_angle * (2.0 * i / facets - 1.0);
    profile.nodes.push_back(top_centre +
                            top_radius * Eigen::Vector2d(std::sin(angle), std::cos(angle)));
  }
  profile.nodes.push_back(point_at(sample_sector, 1.0, half));
  return profile;
}

/// Greatest extent of the top in a direction from its centre, without the plate beside it.
double support(const LinerProfile& profile, double angle) {
  const Eigen::Vector2d direction(std::sin(angle), std::cos(angle));
  double greatest = -1.0;
  for (const auto& node : profile.nodes) {
    if (std::abs(node.x()) > top_radius) continue;
    greatest = std::max(greatest, direction.dot(node - top_centre));
  }
  return greatest;
}

/// Angle of the outward normal against eta, positive towards xi: of a chord of two bins.
double normal_angle(const LinerProfile& profile, double arc_length) {
  const auto lengths = arc_lengths(profile);
  const double aside = lengths.back() / bins;
  const Eigen::Vector2d along = place_at(profile, lengths, arc_length + aside) -
                                place_at(profile, lengths, arc_length - aside);
  return std::atan2(-along.y(), along.x());
}

}  // namespace

ClosedFormLoad even_rate() { return ring("even", 0.0); }

ClosedFormLoad growing_rate() { return ring("growing", 230.0); }

ClosedFormLoad rate_by_slope() {
  constexpr double rate = 3e-9;
  constexpr double slope = 0.8;
  constexpr double duration = 100.0 * day;
  const auto by_direction = [](double angle) { return rate * (1.0 + slope * std::sin(angle)); };
  const LinerProfile fresh = round_lifter();
  return {"slope",
          fresh,
          duration,
          rate * duration * 2.0 * top_half_angle * top_radius,
          0.8,
          0.32,
          [=](const LinerProfile& profile, double arc_length) {
            return by_direction(std::clamp(normal_angle(profile, arc_length), -1.0, 1.0));
          },
          [=](const LinerProfile& worn) {
            double worst = 0.0;
            for (double angle = -compared_within; angle <= compared_within; angle += 0.05) {
              const double exact = support(fresh, angle) - by_direction(angle) * duration;
              worst = std::max(worst, std::abs(support(worn, angle) - exact));
            }
            return worst / (rate * duration);
          }};
}

ClosedFormRun run(const ClosedFormLoad& load, const CampaignSettings& settings) {
  std::vector<TimedLoad> loads;
  LinerProfile liner = load.fresh;
  double time = 0.0;
  for (auto end = EvolutionEnd::load_spent; end != EvolutionEnd::time_reached;) {
    loads.push_back({time, liner, rate_on(liner, load)});
    const auto evolution = evolve(loads, load.wear_scale, settings, load.duration - time);
    for (const auto& step : evolution.steps) time += step.duration;
    liner = evolution.steps.back().profile;
    end = evolution.end;
  }
  return {static_cast<int>(loads.size()), load.error(liner)};
}

std::vector<ClosedFormRun> refined(const ClosedFormLoad& load, Scheme scheme) {
  CampaignSettings settings{.threshold = load.coarsest_threshold,
                            .steps_per_cycle = 8,
                            .height_limit = -1.0,
                            .plate_limit = -1.0,
                            .cycle_limit = 1000,
                            .scheme = scheme,
                            .step_tolerance = load.coarsest_tolerance,
                            .largest_share = 1.0};
  std::vector<ClosedFormRun> runs;
  for (int refinement = 0; refinement < 3; ++refinement) {
    runs.push_back(run(load, settings));
    settings.threshold *= 0.5;
    settings.step_tolerance *= 0.25;
  }
  return runs;
}

double loads_for(double error, const std::vector<ClosedFormRun>& runs) {
  std::size_t i = 1;
  while (i + 1 < runs.size() && runs[i].error > error) ++i;
  const double slope = std::log(runs[i - 1].error / runs[i].error) /
                       std::log(static_cast<double>(runs[i].loads) / runs[i - 1].loads);
  return runs[i].loads * std::pow(runs[i].error / error, 1.0 / slope);
}

double order_of(const std::vector<ClosedFormRun>& runs) {
  const auto& fine = runs[runs.size() - 1];
  const auto& coarse = runs[runs.size() - 2];
  return std::log(coarse.error / fine.error) /
         std::log(static_cast<double>(fine.loads) / coarse.loads);
}

}  // namespace millwear::wear
