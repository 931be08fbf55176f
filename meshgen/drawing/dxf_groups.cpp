#include "meshgen/drawing/dxf_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "mill/base/number_text.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"

namespace millwear::meshgen {
namespace {

static_assert(std::endian::native == std::endian::little, "a binary DXF is read as it lies");

enum class ValueKind { text, real, int16, int32, int64, byte, chunk };

struct CodeRange {
  int first;
  int last;
  ValueKind kind;
};

/// What the value of a code is, as Autodesk's DXF reference has it; all others are text.
constexpr std::array<CodeRange, 20> ranges{{
    {10, 59, ValueKind::real},      {60, 79, ValueKind::int16},    {90, 99, ValueKind::int32},
    {110, 149, ValueKind::real},    {160, 169, ValueKind::int64},  {170, 179, ValueKind::int16},
    {210, 239, ValueKind::real},    {270, 289, ValueKind::int16},  {290, 299, ValueKind::byte},
    {310, 319, ValueKind::chunk},   {370, 389, ValueKind::int16},  {400, 409, ValueKind::int16},
    {420, 429, ValueKind::int32},   {440, 459, ValueKind::int32},  {460, 469, ValueKind::real},
    {1004, 1004, ValueKind::chunk}, {1010, 1059, ValueKind::real}, {1060, 1070, ValueKind::int16},
    {1071, 1071, ValueKind::int32}, {999, 999, ValueKind::text},
}};

constexpr int comment_code = 999;
constexpr int highest_code = 1071;
constexpr std::string_view binary_mark{"AutoCAD Binary DXF\r\n\x1a\0", 22};

ValueKind kind_of(int code) {
  const auto found = std::ranges::find_if(
      ranges, [&](const CodeRange& range) { return range.first <= code && code <= range.last; });
  return found == ranges.end() ? ValueKind::text : found->kind;
}

void check_value(const DxfGroup& group, const std::filesystem::path& file) {
  const ValueKind kind = kind_of(group.code);
  if (kind == ValueKind::text || kind == ValueKind::chunk || number_of(group.value)) return;
  refuse_line(file, group.line,
              fmt::format("{} is not a number (of group {}); mend the drawing",
                          in_quotes(group.value), group.code));
}

[[noreturn]] void refuse_cut_off(const std::filesystem::path& file, int line) {
  refuse_line(file, line, "the drawing ends before its EOF, so the file is cut off; copy it again");
}

bool is_end(const DxfGroup& group) { return group.code == 0 && group.value == "EOF"; }

std::vector<DxfGroup> groups_of_text(std::string_view text, const std::filesystem::path& file) {
  std::vector<DxfGroup> groups;
  int line = 0;
  const auto take_line = [&] {
    if (text.empty()) refuse_cut_off(file, std::max(line, 1));
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line;
    return trimmed(taken);
  };
  while (groups.empty() || !is_end(groups.back())) {
    const std::string_view code_text = take_line();
    int code = -1;
    const auto [end, error] =
        std::from_chars(code_text.data(), code_text.data() + code_text.size(), code);
    const bool is_code = error == std::errc() && end == code_text.data() + code_text.size() &&
                         code >= 0 && code <= highest_code;
    if (!is_code)
      refuse_line(file, line,
                  fmt::format("{} is no group code of a DXF; {}", in_quotes(code_text),
                              groups.empty() ? "give a DXF" : "mend the drawing"));
    DxfGroup group{code, std::string(take_line()), line};
    check_value(group, file);
    if (code != comment_code) groups.push_back(std::move(group));
  }
  return groups;
}

/// Takes values off a binary DXF.
class BinaryGroups {
 public:
  BinaryGroups(std::string_view bytes, const std::filesystem::path& file)
      : left_(bytes.substr(binary_mark.size())),
        has_short_codes_(left_.size() > 1 && left_[0] == '\0' && left_[1] != '\0'),
        file_(file) {}

  [[nodiscard]] std::vector<DxfGroup> all() {
    std::vector<DxfGroup> groups;
    while (groups.empty() || !is_end(groups.back())) {
      ++number_;
      const int code = take_code();
      DxfGroup group{code, take_value(kind_of(code)), number_};
      check_value(group, file_);
      if (code != comment_code) groups.push_back(std::move(group));
    }
    return groups;
  }

 private:
  template <class Number>
  Number take() {
    Number value{};
    if (left_.size() < sizeof value) refuse_cut_off(file_, number_);
    std::memcpy(&value, left_.data(), sizeof value);
    left_.remove_prefix(sizeof value);
    return value;
  }

  int take_code() {
    constexpr int escape = 255;
    if (!has_short_codes_) return take<std::int16_t>();
    const int code = take<std::uint8_t>();
    return code == escape ? take<std::int16_t>() : code;
  }

  std::string take_value(ValueKind kind) {
    switch (kind) {
      case ValueKind::real:
        return fmt::format("{}", take<double>());
      case ValueKind::int16:
        return fmt::format("{}", take<std::int16_t>());
      case ValueKind::int32:
        return fmt::format("{}", take<std::int32_t>());
      case ValueKind::int64:
        return fmt::format("{}", take<std::int64_t>());
      case ValueKind::byte:
        return fmt::format("{}", take<std::uint8_t>());
      case ValueKind::chunk: {
        const std::size_t size = take<std::uint8_t>();
        if (left_.size() < size) refuse_cut_off(file_, number_);
        left_.remove_prefix(size);
        return {};
      }
      case ValueKind::text:
        break;
    }
    const std::size_t end = left_.find('\0');
    if (end == std::string_view::npos) refuse_cut_off(file_, number_);
    std::string text(trimmed(left_.substr(0, end)));
    left_.remove_prefix(end + 1);
    return text;
  }

  std::string_view left_;
  bool has_short_codes_;  ///< of one byte, as up to R12
  const std::filesystem::path& file_;
  int number_ = 0;
};

}  // namespace

std::vector<DxfGroup> dxf_groups(std::string_view bytes, const std::filesystem::path& file) {
  if (bytes.starts_with(binary_mark)) return BinaryGroups(bytes, file).all();
  return groups_of_text(bytes, file);
}

std::string dxf_text(const std::vector<DxfGroup>& groups) {
  std::string text;
  for (const DxfGroup& group : groups)
    fmt::format_to(std::back_inserter(text), "{}\n{}\n", group.code, group.value);
  return text;
}

}  // namespace millwear::meshgen
