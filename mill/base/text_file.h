#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace millwear {

/// The largest case file or profile that is read [bytes].
inline constexpr std::size_t largest_input_file = 64 * 1024;

/// The whole text of a case file or profile, as UTF-8 without a byte order mark; UTF-16 is known by
/// its mark and converted. Throws InputError with file and line if the file is missing, larger than
/// `largest` bytes, or not plain text (see `check_plain_text`).
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file,
                                         std::size_t largest = largest_input_file);

/// Throws InputError with file and line at the first control character other than tab and line
/// break, and at the first byte that is not UTF-8.
void check_plain_text(std::string_view text, const std::filesystem::path& file);

/// `text` between back quotes for a message: shortened, all but printable ASCII escaped.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace millwear
