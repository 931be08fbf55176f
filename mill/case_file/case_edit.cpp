#include "mill/case_file/case_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "mill/base/failure.h"
#include "mill/base/nearest_word.h"
#include "mill/case_keys/case_schema.h"

namespace millwear {
namespace {

std::string dotted_name(const KeySpec& spec) {
  return spec.table.empty() ? std::string(spec.key) : fmt::format("{}.{}", spec.table, spec.key);
}

[[noreturn]] void refuse_key(std::string_view plain, std::string_view dotted) {
  std::vector<std::string> names;
  for (const KeySpec& spec : case_keys()) names.push_back(dotted_name(spec));
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string near = nearest_word(plain, known);
  throw InputError(fmt::format("no case file has a key `{}`; {}", dotted,
                               near.empty()
                                   ? "docs/case_file.md lists them, by table and key: `mill.rows`"
                                   : fmt::format("did you mean `{}`?", near)));
}

/// How a table of several is called: its name, its material, or its two materials.
std::string label_of(const CaseTable& table) {
  for (const char* const key : {"name", "material"})
    if (const CaseValue* const value = table.find(key))
      if (const auto* const text = std::get_if<std::string>(&value->data)) return *text;
  std::string label;
  if (const CaseValue* const value = table.find("materials"))
    if (const auto* const names = std::get_if<CaseArray>(&value->data))
      for (const CaseValue& name : *names)
        if (const auto* const text = std::get_if<std::string>(&name.data))
          label += (label.empty() ? "" : ",") + *text;
  return label;
}

bool is_called(const CaseTable& table, std::size_t number, std::string_view which) {
  const std::string label = label_of(table);
  if (label == which) return true;
  const auto comma = label.find(',');
  if (comma != std::string::npos && label.substr(comma + 1) + "," + label.substr(0, comma) == which)
    return true;
  return std::to_string(number) == which;
}

std::size_t table_number(const CaseDocument& document, const CaseKeyPath& path) {
  std::vector<std::size_t> found;
  std::size_t number = 0;
  std::string labels;
  for (std::size_t i = 0; i < document.tables.size(); ++i) {
    const CaseTable& table = document.tables[i];
    if (table.name != path.table) continue;
    labels += (labels.empty() ? "" : ", ") + label_of(table);
    if (path.which.empty() || is_called(table, number, path.which)) found.push_back(i);
    ++number;
  }
  if (found.size() == 1) return found.front();
  if (number == 0)
    throw InputError(fmt::format("the case has no table [{}]; add it there", path.table));
  throw InputError(fmt::format("the case has {} `{}` called `{}` (there are: {}); name one of them",
                               found.empty() ? "no" : "more than one", path.table, path.which,
                               labels));
}

}  // namespace

CaseKeyPath case_key_path(std::string_view dotted) {
  const auto open = dotted.find('[');
  const auto close = dotted.find(']');
  std::string plain(dotted);
  std::string which;
  if (open != std::string_view::npos && close != std::string_view::npos && close > open) {
    which = std::string(dotted.substr(open + 1, close - open - 1));
    plain = std::string(dotted.substr(0, open)) + std::string(dotted.substr(close + 1));
  }
  std::erase(which, ' ');
  const auto dot = plain.rfind('.');
  CaseKeyPath path{dot == std::string::npos ? "" : plain.substr(0, dot), which,
                   dot == std::string::npos ? plain : plain.substr(dot + 1)};
  if (find_key(path.table, path.key) == nullptr) refuse_key(plain, dotted);
  const TableSpec* const table = find_table_spec(path.table);
  if (table->repeats && which.empty())
    throw InputError(
        fmt::format("`{}` may stand in several tables; name one in brackets, as in "
                    "`{}[steel].{}` or `{}[0].{}`",
                    dotted, path.table, path.key, path.table, path.key));
  if (!table->repeats && !which.empty())
    throw InputError(
        fmt::format("[{}] stands once in a case, so `{}` takes no brackets; write "
                    "`{}`",
                    path.table, dotted, plain));
  return path;
}

CaseDocument with_value(CaseDocument document, const CaseKeyPath& path, CaseValue value) {
  const bool is_optional_table = !find_table_spec(path.table)->required;
  if (is_optional_table && path.which.empty() && document.find(path.table) == nullptr)
    document.tables.push_back({path.table, value.line, false, {}});
  CaseTable& table = document.tables[table_number(document, path)];
  const auto found =
      std::ranges::find_if(table.keys, [&](const auto& entry) { return entry.first == path.key; });
  if (found == table.keys.end())
    table.keys.emplace_back(path.key, std::move(value));
  else
    found->second = std::move(value);
  return document;
}

CaseValue value_from_text(std::string_view text, int line) {
  if (text == "true" || text == "false") return {line, text == "true"};
  const char* const end = text.data() + text.size();
  std::int64_t whole = 0;
  if (const auto read = std::from_chars(text.data(), end, whole);
      read.ec == std::errc{} && read.ptr == end)
    return {line, whole};
  double real = 0.0;
  if (const auto read = std::from_chars(text.data(), end, real);
      read.ec == std::errc{} && read.ptr == end)
    return {line, real};
  return {line, std::string(text)};
}

CaseDocument without_key(CaseDocument document, std::string_view table, std::string_view key) {
  for (CaseTable& one : document.tables)
    if (one.name == table)
      std::erase_if(one.keys, [key](const auto& entry) { return entry.first == key; });
  return document;
}

}  // namespace millwear
