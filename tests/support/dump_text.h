#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace millwear::liggghts {

/// A snapshot as LIGGGHTS's `dump local` writes it.
inline std::string dump_text(long step, const std::vector<std::vector<double>>& rows) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ENTRIES\n{}\n"
      "ITEM: BOX BOUNDS ff pp ff\n-0.55 0.55\n0 0.12\n-0.55 0.55\nITEM: ENTRIES c_hits[1] \n",
      step, rows.size());
  for (const auto& row : rows) text += fmt::format("{} \n", fmt::join(row, " "));
  return text;
}

}  // namespace millwear::liggghts
