#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace millwear::recorder {

/// The commands of a LIGGGHTS input script, one a line: lines that end in `&` are joined with the
/// next, comments and empty lines are left out.
[[nodiscard]] std::vector<std::string> deck_lines(std::string_view deck);

/// The first word of a command.
[[nodiscard]] std::string_view command_of(std::string_view line);

/// The second word of a command, or nothing.
[[nodiscard]] std::string_view argument_of(std::string_view line);

}  // namespace millwear::recorder
