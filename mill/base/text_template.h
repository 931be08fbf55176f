#pragma once
#include <map>
#include <string>
#include <string_view>

namespace millwear {

/// The values that take the place of {{name}} in a template.
using TemplateValues = std::map<std::string, std::string, std::less<>>;

/// `text` with every {{name}} replaced by its value.
/// Throws std::logic_error where a placeholder has no value or a value has no placeholder: a
/// template and the code that fills it must not drift apart.
[[nodiscard]] std::string filled_template(std::string_view text, const TemplateValues& values);

}  // namespace millwear
