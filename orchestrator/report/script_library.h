#pragma once
#include <filesystem>
#include <string>

namespace millwear::orchestrator {

/// A library that a page holds, and the licence that goes with every copy.
struct ScriptLibrary {
  std::string script;
  std::string licence;
};

/// What the report and the comparison are made with: D3 draws, pako unpacks what zlib packed.
struct PageLibraries {
  ScriptLibrary d3;
  ScriptLibrary pako;
};

/// As Debian's libjs-d3 and node-pako install them under `root`. Throws ExternalProgramError naming
/// the package where one is missing.
[[nodiscard]] ScriptLibrary installed_d3(const std::filesystem::path& root = "/");
[[nodiscard]] PageLibraries installed_page_libraries(const std::filesystem::path& root = "/");

}  // namespace millwear::orchestrator
