#include "recorder/run/build_check.h"

#include <fmt/format.h>

#include "mill/base/failure.h"

namespace millwear::recorder {

void check_build(std::string_view built_for, std::string_view running) {
  if (!built_for.empty() && running.find(built_for) != std::string_view::npos) return;
  throw ExternalProgramError(
      fmt::format("millwear-recorder was built for {}, and this is {}; build it again (make "
                  "build), or set wall_contacts = \"dumps\"",
                  built_for, running));
}

}  // namespace millwear::recorder
