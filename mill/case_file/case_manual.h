#pragma once
#include <string>

namespace millwear {

/// The manual of the case file in Markdown, from the schema: docs/case_file.md is this text.
[[nodiscard]] std::string case_file_manual();

}  // namespace millwear
