#pragma once
#include <filesystem>
#include <string_view>

#include "mill/case/case.h"

namespace millwear {

/// Reads and checks a case file (docs/case_file.md). Never writes.
/// Throws InputError with all that is wrong, a line each: "file:line: what; what would be right".
[[nodiscard]] Case read_case(const std::filesystem::path& file);

/// The same for a text in memory; `file` is for messages and for the place of a profile's CSV.
[[nodiscard]] Case case_from_text(std::string_view text, const std::filesystem::path& file);

}  // namespace millwear
