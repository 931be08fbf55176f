#pragma once
#include <string>
#include <string_view>
#include <vector>

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

/// A dataset as HDF5 stores it: its one chunk, shuffled and deflated.
struct PackedDataset {
  std::string name;
  std::string unit;
  std::vector<unsigned long long> sizes;
  std::string bytes;
};

/// The load of one cycle as it stands in a file of many: put into another file without packing it
/// again.
struct PackedLoad {
  int cycle;  ///< >= 0
  std::vector<PackedDataset> datasets;
};

}  // namespace millwear::wear
