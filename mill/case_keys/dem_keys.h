#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/key_row.h"

namespace millwear {

/// The keys of [dem].
[[nodiscard]] const std::vector<KeyRow<DemSettings>>& dem_keys();

}  // namespace millwear
