#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace millwear::recorder {

/// Gives up over wrong options. Throws Failure with ExitCode::usage.
[[noreturn]] void refuse(const std::string& why);

/// Puts the arguments into what `app`'s options are bound to; `help` is named to who errs.
/// Throws Failure with ExitCode::usage.
void parse_options(CLI::App& app, const std::vector<std::string>& arguments,
                   const std::string& help);

}  // namespace millwear::recorder
