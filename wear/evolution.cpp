#include "wear/evolution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mill/failure.h"
#include "wear/profile_index.h"
#include "wear/profile_motion.h"

namespace millwear::wear {
namespace {

constexpr double limit_within = 1e-6;
constexpr double look_aside_share_of_bin = 1.0 / 40.0;
constexpr int most_trials = 60;

/// What is left above the limits.
struct Margin {
  double height;
  double plate;
  [[nodiscard]] double least() const { return std::min(height, plate); }
  [[nodiscard]] EvolutionEnd nearest() const {
    return height <= plate ? EvolutionEnd::height_limit : EvolutionEnd::plate_limit;
  }
};

Margin margin_of(const LinerProfile& profile, const CampaignSettings& settings) {
  return {lifter_height(profile) - settings.height_limit,
          plate_thickness(profile) - settings.plate_limit};
}

Eigen::Vector2d place_at(const LinerProfile& profile, const std::vector<double>& lengths,
                         double arc_length) {
  const double length = lengths.back();
  const double wrapped = arc_length - length * std::floor(arc_length / length);
  const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, wrapped);
  const auto i = static_cast<std::size_t>(above - lengths.begin());
  const double share = (wrapped - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
  return profile.nodes[i - 1] + share * (profile.nodes[i] - profile.nodes[i - 1]);
}

/// The load of the cycle's first profile on a moved one. Both sides of a place are looked up and
/// averaged, because a corner of the moved profile is as near to one face as to the other.
std::vector<LossNode> carried(const LinerProfile& moved, const ProfileIndex& first,
                              const ArcCurve& rate) {
  const auto lengths = arc_lengths(moved);
  const double aside = look_aside_share_of_bin * rate.bin_width();
  const auto rate_near = [&](double arc_length) {
    return rate.at(first.nearest(place_at(moved, lengths, arc_length)).arc_length);
  };
  return loss_nodes(moved, rate.bin_width(), [&](double arc_length) {
    return 0.5 * (rate_near(arc_length - aside) + rate_near(arc_length + aside));
  });
}

struct TimedMove {
  double duration;
  MovedProfile moved;
};

/// The loss rate on a profile, and its section per second.
struct LossRate {
  std::vector<LossNode> nodes;
  double area_rate;
};

TimedMove move_for(const LinerProfile& profile, const LossRate& loss, double duration,
                   double resolution) {
  return {duration, move_profile(profile, scaled(loss.nodes, duration), loss.area_rate * duration,
                                 resolution)};
}

/// A shorter step that ends at the limit; `longest` ends below it.
TimedMove move_to_limit(const LinerProfile& profile, const LossRate& loss, TimedMove longest,
                        double resolution, const CampaignSettings& settings) {
  double low = 0.0;
  double low_margin = margin_of(profile, settings).least();
  double high = longest.duration;
  double high_margin = margin_of(longest.moved.profile, settings).least();
  TimedMove found = std::move(longest);
  for (int trial = 0; trial < most_trials && std::abs(high_margin) > limit_within; ++trial) {
    const bool by_chord = trial % 3 != 2;
    const double share = by_chord ? low_margin / (low_margin - high_margin) : 0.5;
    const double duration = low + (high - low) * std::clamp(share, 0.01, 0.99);
    TimedMove shorter = move_for(profile, loss, duration, resolution);
    const double margin = margin_of(shorter.moved.profile, settings).least();
    const bool is_there = std::abs(margin) <= limit_within;
    (margin > 0.0 && !is_there ? low : high) = duration;
    (margin > 0.0 && !is_there ? low_margin : high_margin) = margin;
    if (margin <= 0.0 || is_there) found = std::move(shorter);
  }
  return found;
}

void check(const ArcCurve& rate, double new_lifter_area, const CampaignSettings& settings) {
  if (!(settings.threshold > 0.0) || settings.steps_per_cycle <= 0 || !(new_lifter_area > 0.0)) {
    throw InputError("a campaign needs a threshold, steps per cycle and a lifter above zero");
  }
  if (!rate.values.allFinite() || rate.values.minCoeff() < 0.0 || !(rate.values.maxCoeff() > 0.0)) {
    throw ResultRejected(
        "the load wears the liner nowhere: no contact did what its law counts while it was "
        "measured; measure for longer, or look at the charge and the law");
  }
}

}  // namespace

Evolution evolve(const LinerProfile& profile, const ArcCurve& rate, double new_lifter_area,
                 const CampaignSettings& settings) {
  check(rate, new_lifter_area, settings);
  Evolution evolution{{}, EvolutionEnd::threshold_reached};
  const Margin at_start = margin_of(profile, settings);
  if (at_start.least() <= limit_within) {
    evolution.end = at_start.nearest();
    return evolution;
  }
  const double resolution = rate.bin_width();
  const double area_per_step = settings.threshold * new_lifter_area / settings.steps_per_cycle;
  const ProfileIndex first(profile, 4.0 * resolution);
  LinerProfile current = profile;
  for (int step = 0; step < settings.steps_per_cycle; ++step) {
    LossRate loss;
    if (step == 0) {
      loss.nodes = loss_nodes(current, resolution, [&](double s) { return rate.at(s); });
      loss.area_rate = rate.values.sum() * resolution;
    } else {
      loss.nodes = carried(current, first, rate);
      loss.area_rate = loss_area(loss.nodes);
    }
    if (!(loss.area_rate > 0.0)) {
      throw ResultRejected("the places that the load wore are gone; lower the threshold");
    }
    TimedMove move = move_for(current, loss, area_per_step / loss.area_rate, resolution);
    const bool reaches_limit = margin_of(move.moved.profile, settings).least() <= 0.0;
    if (reaches_limit) {
      move = move_to_limit(current, loss, std::move(move), resolution, settings);
    }
    current = move.moved.profile;
    evolution.steps.push_back({move.duration, current, move.moved.removed_area,
                               loss.area_rate * move.duration, move.moved.dropped_area});
    const Margin left = margin_of(current, settings);
    if (left.least() <= limit_within) {
      evolution.end = left.nearest();
      return evolution;
    }
  }
  return evolution;
}

}  // namespace millwear::wear
