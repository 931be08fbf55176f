#include "mill/case_file/case_schema_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mill/base/nearest_word.h"
#include "mill/base/text_file.h"
#include "mill/case_keys/case_schema.h"

namespace millwear {
namespace {

bool is_name(std::string_view text) {
  const auto allowed = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), allowed);
}

bool is_choice(std::string_view text, std::string_view choices) {
  return !text.empty() && text.find('|') == std::string_view::npos &&
         fmt::format("|{}|", choices).find(fmt::format("|{}|", text)) != std::string::npos;
}

std::string_view wanted(KeyType type) {
  switch (type) {
    case KeyType::name:
    case KeyType::choice:
    case KeyType::file:
    case KeyType::words:
      return "a text in quotes";
    case KeyType::real:
      return "a number";
    case KeyType::integer:
      return "a whole number";
    case KeyType::boolean:
      return "true or false";
    case KeyType::reals:
      return "an array of numbers";
    case KeyType::names:
      return "an array of two names";
    case KeyType::points:
      return "an array of [xi, eta] pairs";
  }
  return "";
}

std::string found_in(const CaseValue& value) {
  struct Describe {
    std::string operator()(const ForeignValue& v) const { return std::string(v.type); }
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
    std::string operator()(double v) const { return fmt::format("{}", v); }
    std::string operator()(const std::string& v) const { return "the text " + in_quotes(v); }
    std::string operator()(const CaseArray& v) const {
      return fmt::format("an array of {}", v.size());
    }
  };
  return std::visit(Describe{}, value.data);
}

std::optional<double> as_number(const CaseValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    return static_cast<double>(*whole);
  }
  if (const auto* real = std::get_if<double>(&value.data)) {
    return *real;
  }
  return std::nullopt;
}

/// One value against one key of the schema.
class ValueCheck {
 public:
  ValueCheck(const KeySpec& spec, CaseProblems& problems) : spec_(spec), problems_(problems) {}

  void check(const CaseValue& value) const {
    switch (spec_.type) {
      case KeyType::name:
      case KeyType::choice:
      case KeyType::file:
      case KeyType::words:
        return check_text(value, spec_.type);
      case KeyType::boolean:
        return std::holds_alternative<bool>(value.data) ? void() : wrong_type(value, spec_.type);
      case KeyType::integer:
        return std::holds_alternative<std::int64_t>(value.data) ? check_number(value)
                                                                : wrong_type(value, spec_.type);
      case KeyType::real:
        return check_number(value);
      case KeyType::reals:
        return check_array(value, [this](const CaseValue& v) { check_number(v); });
      case KeyType::names:
        return check_array(
            value, [this](const CaseValue& v) { check_text(v, KeyType::name); }, 2);
      case KeyType::points:
        return check_array(value, [this](const CaseValue& point) {
          check_array(
              point, [this](const CaseValue& v) { check_number(v); }, 2);
        });
    }
  }

 private:
  void wrong_type(const CaseValue& value, KeyType type) const {
    problems_.add(value.line, fmt::format("`{}` has the wrong type (found {}); give {}", spec_.key,
                                          found_in(value), wanted(type)));
  }

  void check_number(const CaseValue& value) const {
    const std::optional<double> number = as_number(value);
    if (!number) {
      wrong_type(value, KeyType::real);
    } else if (!std::isfinite(*number)) {
      problems_.add(value.line, fmt::format("`{}` is not finite (found {}); give a number",
                                            spec_.key, *number));
    } else if (!spec_.range.holds(*number)) {
      problems_.add(value.line, fmt::format("`{}` is out of range (found {}); give a number {}",
                                            spec_.key, *number, spec_.range.text()));
    }
  }

  void check_text(const CaseValue& value, KeyType type) const {
    const auto* text = std::get_if<std::string>(&value.data);
    if (text == nullptr) {
      wrong_type(value, type);
    } else if (type == KeyType::name && !is_name(*text)) {
      problems_.add(value.line,
                    fmt::format("`{}` is not a name (found {}); use 1 to 64 of A-Z a-z 0-9 _ -",
                                spec_.key, in_quotes(*text)));
    } else if (type == KeyType::choice && !is_choice(*text, spec_.choices)) {
      problems_.add(value.line, fmt::format("`{}` has no choice {}; give one of {}", spec_.key,
                                            in_quotes(*text), spec_.choices));
    } else if ((type == KeyType::file || type == KeyType::words) &&
               std::ranges::any_of(*text, [](unsigned char c) { return c < ' '; })) {
      problems_.add(value.line, fmt::format("`{}` has control characters (found {}); mend it",
                                            spec_.key, in_quotes(*text)));
    }
  }

  template <typename Check>
  void check_array(const CaseValue& value, const Check& check_element,
                   std::size_t wanted_size = 0) const {
    const auto* array = std::get_if<CaseArray>(&value.data);
    if (array == nullptr || array->empty() || (wanted_size != 0 && array->size() != wanted_size)) {
      wrong_type(value, spec_.type);
      return;
    }
    std::for_each(array->begin(), array->end(), check_element);
  }

  const KeySpec& spec_;
  CaseProblems& problems_;
};

std::string meant(std::string_view word, const std::vector<std::string_view>& known) {
  const std::string near = nearest_word(word, known);
  return near.empty() ? "delete it, or see docs/case_file.md for what there is"
                      : fmt::format("did you mean `{}`?", near);
}

void check_table(const CaseTable& table, const TableSpec& spec, CaseProblems& problems) {
  const std::string heading = table_heading(spec);
  if (table.repeated != spec.repeats && !spec.name.empty()) {
    problems.add(table.line, fmt::format("[{}] is written in the wrong brackets; write {}",
                                         spec.name, heading));
  }
  std::vector<std::string_view> known;
  for (const KeySpec& key : case_keys()) {
    if (key.table != spec.name) {
      continue;
    }
    known.push_back(key.key);
    if (key.presence == Presence::required && table.find(key.key) == nullptr) {
      problems.add(table.line,
                   fmt::format("{} has no `{}` ({}); add it", heading, key.key, key.doc));
    }
  }
  for (const auto& [key, value] : table.keys) {
    if (const KeySpec* const key_spec = find_key(spec.name, key)) {
      ValueCheck(*key_spec, problems).check(value);
    } else {
      problems.add(value.line, fmt::format("unknown key {} in {}; {}", in_quotes(key), heading,
                                           meant(key, known)));
    }
  }
}

}  // namespace

void check_against_schema(const CaseTable& table, CaseProblems& problems) {
  check_table(table, *find_table_spec(table.name), problems);
}

void check_against_schema(const CaseDocument& document, CaseProblems& problems) {
  std::vector<std::string_view> known;
  for (const TableSpec& spec : case_tables()) {
    known.push_back(spec.name);
    if (spec.required && document.find(spec.name) == nullptr) {
      problems.add(1, fmt::format("{} is missing; add it: {}", table_heading(spec), spec.doc));
    }
  }
  for (const CaseTable& table : document.tables) {
    if (const TableSpec* const spec = find_table_spec(table.name)) {
      check_table(table, *spec, problems);
    } else {
      problems.add(table.line, fmt::format("unknown table {}; {}", in_quotes(table.name),
                                           meant(table.name, known)));
    }
  }
}

}  // namespace millwear
