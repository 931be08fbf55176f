#include "mill/case/operated_mill.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "mill/base/constants.h"
#include "mill/case/case_units.h"

namespace millwear {
namespace {

/// "from 3000 h on"
std::string spoken_begin(const OperatingChange& change) {
  return change.from_time ? fmt::format("from {:g} h on", *change.from_time / seconds_per_hour)
                          : fmt::format("from {:g} mm lifter on", 1e3 * *change.from_height);
}

std::string spoken_change(const OperatingChange& change, const Case& operated) {
  std::vector<std::string> parts;
  if (change.speed)
    parts.push_back(fmt::format("{:.2f} rpm ({:.1f} % of critical)",
                                *change.speed / speed_from_rpm(1.0),
                                100.0 * critical_speed_fraction(operated)));
  if (!change.counts.empty())
    parts.push_back(fmt::format("filling {:.1f} %", 100.0 * filling_inside_plate(operated)));
  if (change.feed_rate)
    parts.push_back(fmt::format("feed {:g} t/h", *change.feed_rate / feed_from_t_per_h(1.0)));
  if (change.rotation)
    parts.push_back(*change.rotation == Rotation::as_new ? "turning as when the liner was new"
                                                         : "turning the other way");
  if (change.idle_time > 0.0)
    parts.push_back(fmt::format("after {:g} h at rest", change.idle_time / seconds_per_hour));
  return fmt::format("{} {}", spoken_begin(change), fmt::join(parts, ", "));
}

}  // namespace

Case as_operated(const Case& mill, std::span<const std::size_t> begun) {
  Case operated = mill;
  for (const std::size_t i : begun) {
    const OperatingChange& change = mill.campaign.operation.at(i);
    operated.speed = change.speed.value_or(operated.speed);
    if (change.feed_rate) operated.feed_rate = change.feed_rate;
    for (std::size_t c = 0; c < change.counts.size(); ++c)
      operated.charge.classes.at(c).count = change.counts[c];
  }
  return operated;
}

Rotation rotation_at(const CampaignSettings& campaign, const LinerMoment& moment) {
  Rotation rotation = rotation_after(campaign.reversal_times, moment.time);
  for (const std::size_t i : changes_begun(campaign.operation, moment))
    rotation = campaign.operation[i].rotation.value_or(rotation);
  return rotation;
}

OperationInForce operation_in_force(const CampaignSettings& campaign, const LinerMoment& moment) {
  return {loads_asked_for(campaign.operation, changes_begun(campaign.operation, moment)),
          reversals_by(campaign.reversal_times, moment.time)};
}

LoadRange range_of_load(const CampaignSettings& campaign, const LinerMoment& moment) {
  LoadRange range = range_of_load(campaign.operation, moment);
  if (const auto reversal = time_to_reversal(campaign.reversal_times, moment.time))
    range.time = std::min(range.time, *reversal);
  return range;
}

std::vector<std::string> spoken_operation(const Case& mill) {
  std::vector<std::string> sentences;
  const auto& changes = mill.campaign.operation;
  for (std::size_t i = 0; i < changes.size(); ++i)
    sentences.push_back(spoken_change(changes[i], as_operated(mill, std::vector{i})));
  return sentences;
}

}  // namespace millwear
