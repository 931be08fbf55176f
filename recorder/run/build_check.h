#pragma once
#include <string_view>

namespace millwear::recorder {

/// Throws ExternalProgramError unless `running`, which a LIGGGHTS library says of itself, is the
/// build `built_for` that the recorder was compiled against.
void check_build(std::string_view built_for, std::string_view running);

}  // namespace millwear::recorder
