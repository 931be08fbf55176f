#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/key_row.h"

namespace millwear {

/// The keys of [campaign]. Before they are read, `plate_limit` holds its default.
[[nodiscard]] const std::vector<KeyRow<CampaignSettings>>& campaign_keys();

/// The keys of [gauge].
[[nodiscard]] const std::vector<KeyRow<GaugeSettings>>& gauge_keys();

/// The keys of [[campaign.operation]]; share of critical speed and fillings are left to the
/// builder.
[[nodiscard]] const std::vector<KeyRow<OperatingChange>>& operation_keys();

}  // namespace millwear
