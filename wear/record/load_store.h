#pragma once
#include <string_view>

#include "mill/load/wall_load.h"

namespace millwear::wear {

/// Version and types of the files below; files of another version are refused.
inline constexpr int load_format_version = 4;
inline constexpr std::string_view one_load = "millwear wall load";
inline constexpr std::string_view many_loads = "millwear wall loads";

/// The load of one cycle.
struct StoredLoad {
  int cycle;  ///< >= 0
  WallLoad load;
};

}  // namespace millwear::wear
