#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "orchestrator/postprocess/hand_run.h"

namespace millwear::orchestrator {

/// What the user asks of `millwear postprocess`, besides the case and the folder of the results.
struct PostprocessOptions {
  std::filesystem::path case_file;
  std::filesystem::path out;                       ///< empty: postprocess/NAME
  std::optional<std::filesystem::path> profile{};  ///< of the deck's liner, where it is worn
  HandRun run{};                                   ///< but for its angle
  double angle_deg = 0.0;                          ///< that angle [degrees]
  std::optional<double> hours{};                   ///< of milling to wear for
  bool json = false;
};

/// Carries out the verb and prints its result. Throws Failures and Interrupted.
void postprocess(const PostprocessOptions& options);

}  // namespace millwear::orchestrator
