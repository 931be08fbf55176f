#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mill/case/case.h"

namespace millwear {

/// A mill as it is operated after some changes of `campaign.operation`, given by their numbers:
/// speed, particle counts and feed rate are those of the last that gives them.
[[nodiscard]] Case as_operated(const Case& mill, std::span<const std::size_t> begun);

/// Which way the mill turns at a moment: as the last change says that has begun and gives a
/// rotation; where none does, by `campaign.reversal_times`.
[[nodiscard]] Rotation rotation_at(const CampaignSettings& campaign, const LinerMoment& moment);

/// What decides the motion of the charge at a moment, apart from the liner. Where two are equal,
/// the same operation was in force all the time between them.
struct OperationInForce {
  std::vector<std::size_t> changes;  ///< numbers of those that ask for a load
  int reversals;                     ///< by `campaign.reversal_times`
  bool operator==(const OperationInForce&) const = default;
};

[[nodiscard]] OperationInForce operation_in_force(const CampaignSettings& campaign,
                                                  const LinerMoment& moment);

/// Up to where the load of a moment holds: to the next reversal or change that asks for a load.
[[nodiscard]] LoadRange range_of_load(const CampaignSettings& campaign, const LinerMoment& moment);

/// A sentence a change: "from 3000 h on 12.20 rpm (80.3 % of critical), filling 35.0 %".
[[nodiscard]] std::vector<std::string> spoken_operation(const Case& mill);

}  // namespace millwear
