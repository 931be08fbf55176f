#include "orchestrator/report/script_library.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

std::string content(const std::filesystem::path& path, const std::string& package) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file || text.empty())
    throw ExternalProgramError(
        fmt::format("{0}: cannot be read, and the report is drawn with it; install {1} "
                    "(apt-get install {1})",
                    path.string(), package));
  return text;
}

ScriptLibrary installed(const std::filesystem::path& root, const std::string& package,
                        const std::string& script) {
  return {.script = content(root / script, package),
          .licence = content(root / "usr/share/doc" / package / "copyright", package)};
}

}  // namespace

ScriptLibrary installed_d3(const std::filesystem::path& root) {
  return installed(root, "libjs-d3", "usr/share/javascript/d3/d3.min.js");
}

PageLibraries installed_page_libraries(const std::filesystem::path& root) {
  return {installed_d3(root),
          installed(root, "node-pako", "usr/share/nodejs/pako/dist/pako_inflate.min.js")};
}

}  // namespace millwear::orchestrator
