#include "mill/case_keys/case_document.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/failure.h"

// Some malformed files (`[,a]`) break assertions inside toml++ 3.3, which abort a debug build.
// Without them its parser goes on to report the error, in every build as in a release.
#define TOML_ASSERT(expression) static_cast<void>(0)
#include <toml++/toml.h>

namespace millwear {
namespace {

constexpr int deepest_table = 2;
constexpr int deepest_array = 3;

int line_of_node(const toml::node& node) {
  return std::max(1, static_cast<int>(node.source().begin.line));
}

CaseValue value_of(const toml::node& node, int depth) {
  const int line = line_of_node(node);
  switch (node.type()) {
    case toml::node_type::string:
      return {line, node.as_string()->get()};
    case toml::node_type::integer:
      return {line, node.as_integer()->get()};
    case toml::node_type::floating_point:
      return {line, node.as_floating_point()->get()};
    case toml::node_type::boolean:
      return {line, node.as_boolean()->get()};
    case toml::node_type::array: {
      if (depth >= deepest_array) {
        return {line, ForeignValue{"an array too deep"}};
      }
      CaseArray values;
      for (const toml::node& element : *node.as_array()) {
        values.push_back(value_of(element, depth + 1));
      }
      return {line, std::move(values)};
    }
    case toml::node_type::table:
      return {line, ForeignValue{"a table"}};
    default:
      return {line, ForeignValue{"a date or time"}};
  }
}

void append_table(CaseDocument& document, const std::string& name, const toml::table& table,
                  bool repeated, int depth) {
  const std::size_t index = document.tables.size();
  document.tables.push_back({name, line_of_node(table), repeated, {}});
  const std::string prefix = name.empty() ? "" : name + ".";
  for (const auto& [key, node] : table) {
    const std::string key_name(key.str());
    const bool may_nest = depth < deepest_table;
    if (const toml::table* inner = node.as_table(); inner != nullptr && may_nest) {
      append_table(document, prefix + key_name, *inner, false, depth + 1);
    } else if (node.is_array_of_tables() && may_nest) {
      for (const toml::node& element : *node.as_array()) {
        append_table(document, prefix + key_name, *element.as_table(), true, depth + 1);
      }
    } else {
      document.tables[index].keys.emplace_back(key_name, value_of(node, 0));
    }
  }
}

/// toml++ recurses once a part of a dotted key: thousands of parts overflow the stack.
void refuse_deep_keys(std::string_view text, const std::filesystem::path& file) {
  constexpr int most_parts = 32;
  int line = 1;
  int dots = 0;
  bool blank_so_far = true;
  bool comment = false;
  for (const char c : text) {
    comment = c != '\n' && (comment || (blank_so_far && c == '#'));
    blank_so_far = c == '\n' || (blank_so_far && (c == ' ' || c == '\t'));
    line += c == '\n' ? 1 : 0;
    const bool ends_a_key = std::string_view("\n=,[]{}").find(c) != std::string_view::npos;
    dots = ends_a_key || comment ? 0 : dots + (c == '.' ? 1 : 0);
    if (dots >= most_parts) {
      throw InputError(fmt::format(
          "{}:{}: a dotted key has too many parts ({} or more, no key here has over 3); mend it",
          file.string(), line, most_parts));
    }
  }
}

}  // namespace

const CaseValue* CaseTable::find(std::string_view key) const {
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [key](const auto& entry) { return entry.first == key; });
  return found == keys.end() ? nullptr : &found->second;
}

const CaseTable* CaseDocument::find(std::string_view table) const {
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [table](const CaseTable& t) { return t.name == table; });
  return found == tables.end() ? nullptr : &*found;
}

std::vector<const CaseTable*> CaseDocument::all(std::string_view table) const {
  std::vector<const CaseTable*> found;
  for (const CaseTable& t : tables) {
    if (t.name == table) {
      found.push_back(&t);
    }
  }
  return found;
}

int CaseDocument::line_of(std::string_view table, std::string_view key) const {
  const CaseTable* const found = find(table);
  if (found == nullptr) {
    return 1;
  }
  const CaseValue* const value = found->find(key);
  return value == nullptr ? found->line : value->line;
}

CaseDocument parse_case_document(std::string_view text, const std::filesystem::path& file) {
  refuse_deep_keys(text, file);
  try {
    CaseDocument document{file, {}};
    append_table(document, "", toml::parse(text), false, 0);
    return document;
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: not TOML ({}); see https://toml.io for how it is written",
                                 file.string(), error.source().begin.line, error.description()));
  }
}

}  // namespace millwear
