#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace millwear::meshgen {

/// The unit of a DXF: a code that says what follows, and a value. A value that is a number is one.
struct DxfGroup {
  int code;
  std::string value;
  int line;  ///< of the value; in a binary file the number of the group
};

/// The groups of an ASCII or a binary DXF, without comments. Throws InputError (file:line) for a
/// file that is none, a code or a number that does not parse, and a file that ends before its EOF.
[[nodiscard]] std::vector<DxfGroup> dxf_groups(std::string_view bytes,
                                               const std::filesystem::path& file);

/// The groups as an ASCII DXF.
[[nodiscard]] std::string dxf_text(const std::vector<DxfGroup>& groups);

}  // namespace millwear::meshgen
