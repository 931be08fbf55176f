#include "mill/base/text_file.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "mill/base/failure.h"

namespace millwear {
namespace {

/// Bytes of the UTF-8 sequence at the start of `text`; 0 if there is none that is valid
/// (overlong, a surrogate, above U+10FFFF or cut short).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) {
      return 0;
    }
  }
  const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
  const bool too_high = lead == 0xf4 && byte(1) >= 0x90;
  return overlong || surrogate || too_high ? 0 : length;
}

bool is_control(char c) {
  const auto byte = static_cast<std::uint8_t>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7f;
}

constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

bool has_utf16_mark(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

std::string from_utf16(std::string bytes, const std::filesystem::path& file) {
  const iconv_t conversion = iconv_open("UTF-8", "UTF-16");
  std::string text(2 * bytes.size(), '\0');  // a unit of two bytes becomes three at most
  char* in = bytes.data();
  char* out = text.data();
  std::size_t in_left = bytes.size();
  std::size_t out_left = text.size();
  const std::size_t failed = iconv(conversion, &in, &in_left, &out, &out_left);
  iconv_close(conversion);
  if (failed == static_cast<std::size_t>(-1))
    throw InputError(
        fmt::format("{}:1: the file begins like UTF-16 and is not (at byte {}); save it as UTF-8",
                    file.string(), bytes.size() - in_left));
  text.resize(text.size() - out_left);
  return text;
}

}  // namespace

void check_plain_text(std::string_view text, const std::filesystem::path& file) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0 || is_control(text[i])) {
      throw InputError(fmt::format(
          "{}:{}: not plain text (byte 0x{:02x} is {}); write it as UTF-8 without control "
          "characters",
          file.string(), line, static_cast<std::uint8_t>(text[i]),
          length == 0 ? "not UTF-8" : "a control character"));
    }
    line += text[i] == '\n' ? 1 : 0;
    i += length;
  }
}

std::string read_text_file(const std::filesystem::path& file, std::size_t largest) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError(
        fmt::format("{}:1: the file cannot be read (it is missing, a folder or not yours to read); "
                    "check its name",
                    file.string()));
  }
  std::string text(largest + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest) {
    throw InputError(
        fmt::format("{}:1: the file is too large (over {} KiB, {} KiB at most); keep "
                    "one mill or one profile a file",
                    file.string(), largest / 1024, largest / 1024));
  }
  if (has_utf16_mark(text)) text = from_utf16(std::move(text), file);
  if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
  check_plain_text(text, file);
  return text;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown;
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<std::uint8_t>(c);
    shown += byte < 0x20 || byte >= 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return fmt::format("`{}{}`", shown, text.size() > longest ? "..." : "");
}

}  // namespace millwear
