#include "mill/base/text_template.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

namespace millwear {

std::string filled_template(std::string_view text, const TemplateValues& values) {
  std::string filled;
  std::set<std::string_view> used;
  while (true) {
    const auto open = text.find("{{");
    filled += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const auto close = text.find("}}", open);
    if (close == std::string_view::npos)
      throw std::logic_error("template: a {{ is never closed; write {{name}}");
    const auto name = text.substr(open + 2, close - open - 2);
    const auto value = values.find(name);
    if (value == values.end())
      throw std::logic_error(fmt::format("template: no value for {{{{{}}}}}", name));
    filled += value->second;
    used.insert(value->first);
    text.remove_prefix(close + 2);
  }
  for (const auto& [name, value] : values)
    if (!used.contains(name))
      throw std::logic_error(fmt::format("template: {{{{{}}}}} is never used", name));
  return filled;
}

}  // namespace millwear
