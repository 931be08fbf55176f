#include "mill/liner/profile_csv.h"

#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_ends.h"

namespace millwear {

namespace {

struct NodeRows {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<int> lines;
};

NodeRows read_node_rows(const std::filesystem::path& file) {
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
  NodeRows read;
  for (const UserRow& row : table.rows) {
    read.nodes.emplace_back(number_in(table, row, xi, metres), number_in(table, row, eta, metres));
    read.lines.push_back(row.line);
  }
  return read;
}

}  // namespace

std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file) {
  return read_node_rows(file).nodes;
}

LinerProfile read_profile_csv(const std::filesystem::path& file, const LinerSector& sector) {
  try {
    const NodeRows read = read_node_rows(file);
    if (const auto again = first_repeated_node(read.nodes)) {
      const Eigen::Vector2d& node = read.nodes[*again];
      refuse_line(file, read.lines[*again],
                  fmt::format("the node ({:.6g}, {:.6g}) m is given twice; delete one of the two",
                              node.x(), node.y()));
    }
    return completed_profile(sector, read.nodes);
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
