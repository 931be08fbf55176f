#include "orchestrator/report/d3.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file || text.empty())
    throw ExternalProgramError(
        fmt::format("{}: cannot be read, and the report is drawn with it; install libjs-d3 "
                    "(apt-get install libjs-d3)",
                    path.string()));
  return text;
}

}  // namespace

D3 installed_d3(const std::filesystem::path& root) {
  return {.script = content(root / "usr/share/javascript/d3/d3.min.js"),
          .licence = content(root / "usr/share/doc/libjs-d3/copyright")};
}

}  // namespace millwear::orchestrator
