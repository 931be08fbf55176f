#pragma once
#include <string>
#include <string_view>

namespace millwear::orchestrator {

/// What gnuplot writes to its standard output when it runs `commands`. Throws ExternalProgramError,
/// naming the package gnuplot-nox where it is missing and quoting it where it fails.
[[nodiscard]] std::string gnuplot_output(std::string_view commands);

}  // namespace millwear::orchestrator
