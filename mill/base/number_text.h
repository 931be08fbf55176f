#pragma once
#include <optional>
#include <string_view>

namespace millwear {

/// `text` without blanks, tabs and carriage returns around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The finite number that a text is, with a plus sign or without; none where it is anything else.
[[nodiscard]] std::optional<double> number_of(std::string_view text);

}  // namespace millwear
