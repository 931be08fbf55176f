#include "mill/liner/profile_csv.h"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/liner/profile_ends.h"

namespace millwear {

std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file) {
  const UserTable table = user_table(read_text_file(file), file);
  if (table.header.line == 0) {
    refuse_line(file, 1,
                "the profile is empty; its first line is `xi_m,eta_m`, then a node a line");
  }
  const auto column = [&](std::string_view name) {
    const auto found = column_named(table, name);
    if (!found) {
      refuse_line(file, table.header.line,
                  fmt::format("no column `{}` in the header; it reads `xi_m,eta_m`", name));
    }
    return *found;
  };
  const std::size_t xi = column("xi_m");
  const std::size_t eta = column("eta_m");
  constexpr std::string_view metres = "metres, such as 0.215";
  std::vector<Eigen::Vector2d> nodes;
  for (const UserRow& row : table.rows) {
    nodes.emplace_back(number_in(table, row, xi, metres), number_in(table, row, eta, metres));
  }
  return nodes;
}

LinerProfile read_profile_csv(const std::filesystem::path& file, const LinerSector& sector) {
  try {
    return completed_profile(sector, read_profile_nodes(file));
  } catch (const InputError& error) {
    const std::string text = error.what();
    if (text.starts_with(file.string() + ":")) {
      throw;
    }
    throw InputError(fmt::format("{}:1: {}", file.string(), text));
  }
}

std::string profile_csv(const LinerProfile& profile) {
  std::string text = "# millwear profile 1\nxi_m,eta_m\n";
  for (const auto& node : profile.nodes)
    fmt::format_to(std::back_inserter(text), "{},{}\n", node.x(), node.y());
  return text;
}

}  // namespace millwear
