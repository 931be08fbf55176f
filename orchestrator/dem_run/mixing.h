#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/case/case.h"
#include "mill/load/mixing_record.h"
#include "orchestrator/dem_run/progress.h"

namespace millwear::orchestrator {

/// What millwear-recorder is told of a mixing stretch that ends once it is steady.
[[nodiscard]] std::vector<std::string> mixing_arguments(const Case& mill, int ranks);

/// How a mixing stretch in `folder` went that may end once it is steady. Throws DiskError where it
/// left nothing, ResultRejected where that cannot be understood or is of another case.
[[nodiscard]] MixingRecord read_mixing(const Case& mill, const std::filesystem::path& folder);

/// Tells the progress from each line that the recorder prints how far the charge still drifts.
[[nodiscard]] std::function<void(std::string_view)> drift_follower(const std::string& stage,
                                                                   Progress& progress);

}  // namespace millwear::orchestrator
