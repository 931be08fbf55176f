#pragma once
#include <string>
#include <vector>

#include "mill/recording/recorder_orders.h"

namespace millwear::recorder {

/// What the recorder is to do, from the words of its command line (`to_arguments`).
/// Throws Failure (usage) for an option that is unknown, missing or no number, and for steps that
/// do not fit.
[[nodiscard]] RecordingPlan recording_plan(const std::vector<std::string>& arguments);

/// The text of --help.
[[nodiscard]] std::string recording_help();

}  // namespace millwear::recorder
