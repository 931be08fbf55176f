#include "mill/profile_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "mill/case_text.h"
#include "mill/failure.h"
#include "mill/profile_ends.h"

namespace millwear {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t comma = std::min(line.find(',', start), line.size());
    fields.push_back(trimmed(line.substr(start, comma - start)));
    start = comma + 1;
  }
  return fields;
}

struct Columns {
  std::size_t xi;
  std::size_t eta;
  std::size_t count;
};

class ProfileReader {
 public:
  explicit ProfileReader(const std::filesystem::path& file) : file_(file) {}

  std::vector<Eigen::Vector2d> nodes_of(std::string_view text) {
    std::vector<Eigen::Vector2d> nodes;
    std::optional<Columns> columns;
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
      text.remove_prefix(std::min(end + 1, text.size()));
      if (line.empty()) {
        continue;
      }
      const auto fields = fields_of(line);
      if (!columns) {
        columns = columns_of(fields);
        continue;
      }
      if (fields.size() != columns->count) {
        fail(fmt::format("{} values where the header names {}; give one value a column",
                         fields.size(), columns->count));
      }
      nodes.emplace_back(number(fields[columns->xi]), number(fields[columns->eta]));
    }
    if (!columns) {
      fail("the profile is empty; its first line is `xi_m,eta_m`, then a node a line");
    }
    return nodes;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), std::max(line_, 1), what));
  }

  Columns columns_of(const std::vector<std::string_view>& header) const {
    const auto find = [&](std::string_view name) {
      const auto found = std::find(header.begin(), header.end(), name);
      if (found == header.end()) {
        fail(fmt::format("no column `{}` in the header; it reads `xi_m,eta_m`", name));
      }
      return static_cast<std::size_t>(found - header.begin());
    };
    return {find("xi_m"), find("eta_m"), header.size()};
  }

  double number(std::string_view text) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      fail(fmt::format("`{}` is not a number (metres, such as 0.215); mend the value",
                       text.substr(0, 40)));
    }
    return value;
  }

  std::filesystem::path file_;
  int line_ = 0;
};

}  // namespace

std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file) {
  return ProfileReader(file).nodes_of(read_text_file(file));
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
