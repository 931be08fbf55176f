#include "mill/liner/profile_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "mill/base/failure.h"
#include "mill/base/text_file.h"
#include "mill/base/user_table.h"
#include "mill/liner/profile_ends.h"

namespace millwear {

namespace {

CurveRows read_rows(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  const CurveRows curve = curve_rows(text, file);
  if (curve.frame != CurveFrame::master)
    refuse_line(file, 1, "no column `xi_m` in the header; it reads `xi_m,eta_m`");
  return curve;
}

}  // namespace

std::vector<Eigen::Vector2d> read_profile_nodes(const std::filesystem::path& file) {
  return read_rows(file).nodes;
}

void check_has_both_ends(const CurveRows& curve, const LinerSector& sector,
                         const std::filesystem::path& file) {
  if (!curve.is_whole_pitch || curve.nodes.empty()) return;
  const double more = sector.plate_radius * (angle_of(sector, curve.nodes.front()) +
                                             angle_of(sector, curve.nodes.back()));
  if (std::abs(more) <= profile_end_tolerance) return;
  refuse_line(file, curve.lines.back(),
              fmt::format("the profile's ends lie {:.1f} mm apart from each other's mirror image, "
                          "and they are one point of two neighbouring pitches; a part of the file "
                          "is missing, copy it again",
                          1e3 * std::abs(more)));
}

LinerProfile read_profile_csv(const std::filesystem::path& file, const LinerSector& sector) {
  try {
    CurveRows read = read_rows(file);
    check_has_both_ends(read, sector, file);
    read.nodes.erase(std::unique(read.nodes.begin(), read.nodes.end()), read.nodes.end());
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
