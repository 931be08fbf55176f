#include "wear/evolve/evolution.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "wear/evolve/profile_motion.h"
#include "wear/evolve/step_control.h"
#include "wear/evolve/surface_loss.h"

namespace millwear::wear {
namespace {

constexpr int most_trials = 60;
constexpr int most_halvings = 8;

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

struct TimedMove {
  double duration;
  MovedProfile moved;
};

/// The loss on a profile, and its section per second.
struct LossRate {
  SurfaceLoss surface;
  double area_rate;
};

TimedMove move_for(const LinerProfile& profile, const LossRate& loss, double duration,
                   double resolution) {
  return {duration, move_profile(profile, depths_after(loss.surface, duration),
                                 loss.area_rate * duration, resolution)};
}

/// The move of a step, or where that is more than the load can take, of its half, its quarter ...
TimedMove move_for_at_most(const LinerProfile& profile, const LossRate& loss, double duration,
                           double resolution) {
  for (int halvings = 0;; ++halvings) {
    try {
      return move_for(profile, loss, duration, resolution);
    } catch (const ResultRejected&) {
      if (halvings == most_halvings) throw;
      duration *= 0.5;
    }
  }
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

void check(const TimedLoad& load, double new_lifter_area, const CampaignSettings& settings,
           double longest) {
  expect(settings.threshold > 0.0 && settings.steps_per_cycle > 0 && new_lifter_area > 0.0 &&
             longest > 0.0,
         "threshold, steps per cycle, time and area of the new lifter are above zero");
  const Eigen::VectorXd& rate = load.rate.values;
  if (!rate.allFinite() || rate.minCoeff() < 0.0 || !(rate.maxCoeff() > 0.0)) {
    throw ResultRejected(
        "the load wears the liner nowhere: no contact did what its law counts while it was "
        "measured; measure for longer, or look at the charge and the law");
  }
}

/// How a cycle is cut into geometry steps.
class StepPlan {
 public:
  StepPlan(std::span<const TimedLoad> loads, double new_lifter_area,
           const CampaignSettings& settings)
      : scheme_(settings.scheme),
        section_(settings.threshold * new_lifter_area / settings.steps_per_cycle),
        duration_(scheme_ == Scheme::adaptive
                      ? time_to_next_load(loads, new_lifter_area, settings) /
                            settings.steps_per_cycle
                      : 0.0) {}

  /// Of the next step under a load that takes so much section per second [s].
  [[nodiscard]] double duration(double area_rate) const {
    return scheme_ == Scheme::adaptive ? duration_ : section_ / area_rate;
  }

  /// The time within the next step, from `now`, whose load is taken for the whole of it [s].
  [[nodiscard]] double middle(double now) const { return now + 0.5 * duration_; }

 private:
  Scheme scheme_;
  double section_;
  double duration_;
};

/// The loss on a profile worn from the load's liner. On the liner itself it takes what was
/// measured; what the surface there takes more or less goes with the rest of the way as one factor.
LossRate loss_on(const LinerProfile& profile, const LoadInTime& load, double time) {
  LossRate loss{surface_loss(profile, load, time), load.section_rate(time)};
  if (profile.nodes == load.liner().nodes) return loss;
  const bool is_measured = load.balls().mean > 0.0 || load.balls().smallest > 0.0;
  const double first =
      is_measured ? section_rate(surface_loss(load.liner(), load, time)) : loss.area_rate;
  loss.area_rate *= section_rate(loss.surface) / first;
  return loss;
}

}  // namespace

std::string_view name_of(EvolutionEnd end) {
  switch (end) {
    case EvolutionEnd::load_spent:
      return "load_spent";
    case EvolutionEnd::height_limit:
      return "height_limit";
    case EvolutionEnd::plate_limit:
      return "plate_limit";
    case EvolutionEnd::time_reached:
      return "time_reached";
  }
  throw std::logic_error("an end of no kind");
}

Evolution evolve(std::span<const TimedLoad> loads, double new_lifter_area,
                 const CampaignSettings& settings, double longest) {
  const LoadInTime load(in_use(loads, settings.scheme));
  const TimedLoad& newest = loads.back();
  check(newest, new_lifter_area, settings, longest);
  Evolution evolution{{}, EvolutionEnd::load_spent};
  const Margin at_start = margin_of(newest.profile, settings);
  if (at_start.least() <= limit_within) {
    evolution.end = at_start.nearest();
    return evolution;
  }
  const double resolution = load.carrier().bin_width();
  const StepPlan plan(loads, new_lifter_area, settings);
  LinerProfile current = newest.profile;
  double elapsed = 0.0;
  for (int step = 0; step < settings.steps_per_cycle; ++step) {
    const LossRate loss = loss_on(current, load, plan.middle(newest.time + elapsed));
    const bool is_all_gone = !(loss.area_rate > 0.0);
    if (is_all_gone) return evolution;
    const double left_of_time = longest - elapsed;
    TimedMove move = move_for_at_most(
        current, loss, std::min(plan.duration(loss.area_rate), left_of_time), resolution);
    const bool is_last_in_time = move.duration == left_of_time;
    const bool reaches_limit = margin_of(move.moved.profile, settings).least() <= 0.0;
    if (reaches_limit) {
      move = move_to_limit(current, loss, std::move(move), resolution, settings);
    }
    current = move.moved.profile;
    elapsed += move.duration;
    evolution.steps.push_back({move.duration, current, move.moved.removed_area,
                               loss.area_rate * move.duration, move.moved.dropped_area});
    const Margin left = margin_of(current, settings);
    if (left.least() <= limit_within) {
      evolution.end = left.nearest();
      return evolution;
    }
    if (is_last_in_time) {
      evolution.end = EvolutionEnd::time_reached;
      return evolution;
    }
  }
  return evolution;
}

}  // namespace millwear::wear
