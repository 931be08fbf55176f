#pragma once
#include <filesystem>
#include <string>

namespace millwear::orchestrator {

/// D3, the drawing library of the report, and the licence that goes with every copy.
struct D3 {
  std::string script;
  std::string licence;
};

/// D3 as Debian's libjs-d3 installs it under `root`. Throws ExternalProgramError naming the package
/// where it is missing.
[[nodiscard]] D3 installed_d3(const std::filesystem::path& root = "/");

}  // namespace millwear::orchestrator
