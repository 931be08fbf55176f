#include "orchestrator/gauge/gauge_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/user_table.h"
#include "mill/liner/profile_crossing.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_ends.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "wear/gauge/alignment_fit.h"
#include "wear/gauge/point_order.h"
#include "wear/gauge/scan_thinning.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using wear::Curve;

constexpr std::size_t most_nodes = 1000;
constexpr double wider = 1.5;
constexpr int most_widenings = 5;
constexpr double most_pitches = 3.0;
constexpr double least_pitches = 0.1;

void check_size(const Curve& curve, const LinerSector& sector, const std::string& file) {
  if (curve.size() < 3)
    throw InputError(
        fmt::format("{}: {} points are no profile; give at least 3", file, curve.size()));
  const double pitch = sector.pitch() * sector.plate_radius;
  const double extent = wear::extent_of(curve);
  if (extent > most_pitches * pitch || extent < least_pitches * pitch)
    throw InputError(
        fmt::format("{}: the curve is {:.4g} m across, and a pitch of the plate is {:.4g} m; say "
                    "its unit with --unit m or --unit mm",
                    file, extent, pitch));
}

struct Aligned {
  LinerProfile profile;
  wear::AlignedCurve curve;
  std::optional<wear::FitQuality> fit;
};

double end_tolerance(double error) { return std::max(profile_end_tolerance, error); }

Aligned align(const Case& mill, const ImportRequest& request, AlignmentMode mode,
              const Curve& curve) {
  const LinerSector& sector = mill.liner.sector;
  const LinerProfile reference =
      request.reference ? read_profile_csv(*request.reference, sector) : mill.liner;
  const auto complete = [&](wear::AlignedCurve aligned, std::optional<wear::FitQuality> fit) {
    auto profile = completed_profile(sector, aligned.nodes, end_tolerance(request.error));
    return Aligned{std::move(profile), std::move(aligned), fit};
  };
  if (mode == AlignmentMode::fit) {
    auto fitted = wear::aligned_by_fit(reference, curve, request.error);
    return complete(std::move(fitted.curve), fitted.quality);
  }
  if (mode == AlignmentMode::ends) {
    const double end_radius = request.plate_thickness
                                  ? sector.shell_radius - *request.plate_thickness
                                  : radius_of(sector, reference.nodes.front());
    return complete(wear::aligned_by_ends(reference, curve, end_radius, request.error), {});
  }
  return complete(wear::kept_in_place(sector, curve), {});
}

/// Aligns the curve; one that crosses itself is averaged, wider and wider, until it does not.
Aligned align_thinned(const Case& mill, const ImportRequest& request, AlignmentMode mode,
                      const Curve& curve) {
  Aligned aligned =
      align(mill, request, mode, wear::thinned_scan(curve, request.error, most_nodes));
  double spacing = wear::group_of_scan(curve, request.error, most_nodes);
  for (int i = 0; first_crossing(aligned.profile).first >= 0; ++i, spacing *= wider) {
    if (i == most_widenings)
      throw InputError("the profile crosses itself; mend its points, or give the error they have");
    aligned = align(mill, request, mode, wear::averaged_scan(curve, spacing));
  }
  return aligned;
}

/// Index of the point of `curve` that is nearest to `place`.
std::size_t nearest_point(const Curve& curve, const Eigen::Vector2d& place) {
  const auto nearest = std::ranges::min_element(
      curve, {}, [&](const Eigen::Vector2d& node) { return (node - place).norm(); });
  return static_cast<std::size_t>(nearest - curve.begin());
}

/// Refuses points that are not in the order of the profile.
void check_order(const CurveRows& curve, const ImportRequest& request) {
  constexpr double errors_a_loop = 2.0;
  const Curve thinned = wear::thinned_scan(curve.nodes, request.error, most_nodes);
  const bool is_averaged = thinned.size() != curve.nodes.size();
  const double noise =
      is_averaged ? wear::group_of_scan(curve.nodes, request.error, most_nodes) : request.error;
  const auto disorder = wear::first_disorder(thinned, errors_a_loop * noise);
  if (!disorder) return;
  const std::size_t first = nearest_point(curve.nodes, thinned[disorder->first]);
  const std::size_t last = nearest_point(curve.nodes, thinned[disorder->last]);
  constexpr std::string_view what =
      "are not in their order along the profile, which crosses itself or turns back there; list "
      "them from one end to the other";
  const fs::path& file = request.curve->path;
  if (curve.lines.empty())
    throw InputError(fmt::format("{}: the points from ({:.4g}, {:.4g}) to ({:.4g}, {:.4g}) m {}",
                                 file.string(), curve.nodes[first].x(), curve.nodes[first].y(),
                                 curve.nodes[last].x(), curve.nodes[last].y(), what));
  refuse_line(
      file, curve.lines[first],
      fmt::format("the points of lines {} to {} {}", curve.lines[first], curve.lines[last], what));
}

AlignmentMode mode_for(const ImportRequest& request, const CurveRows& curve) {
  if (request.align != AlignmentMode::by_file) return request.align;
  return curve.frame == CurveFrame::master ? AlignmentMode::none : AlignmentMode::fit;
}

/// What a curve of several pieces is drawn as, for a message.
std::string spoken_pieces(const std::vector<std::string>& pieces) {
  constexpr std::size_t most = 8;
  if (pieces.size() < 2) return {};
  const std::span<const std::string> shown(pieces.data(), std::min(most, pieces.size()));
  return fmt::format(" (the profile is drawn as {}{})", fmt::join(shown, ", "),
                     pieces.size() > most ? fmt::format(" and {} more", pieces.size() - most) : "");
}

void add_profile(const Case& mill, const ImportRequest& request, ImportedReading& imported) {
  const std::string file = request.curve->path.string();
  GaugeCurve drawn = read_gauge_curve(*request.curve);
  imported.left_out = std::move(drawn.left_out);
  CurveRows& curve = drawn.rows;
  check_size(curve.nodes, mill.liner.sector, file);
  imported.points = curve.nodes.size();
  if (curve.frame == CurveFrame::master)
    check_has_both_ends(curve, mill.liner.sector, request.curve->path);
  check_order(curve, request);
  curve.nodes.erase(std::unique(curve.nodes.begin(), curve.nodes.end()), curve.nodes.end());
  if (request.mirror) curve.nodes = wear::mirror_image(curve.nodes);
  try {
    Aligned aligned = align_thinned(mill, request, mode_for(request, curve), curve.nodes);
    imported.reading.lifter_height = lifter_height(aligned.profile);
    imported.reading.plate_thickness = plate_thickness(aligned.profile);
    imported.reading.profile = std::move(aligned.profile);
    imported.alignment = std::move(aligned.curve);
    imported.fit = aligned.fit;
  } catch (const InputError& problem) {
    throw InputError(fmt::format("{}: {}{}", file, problem.what(), spoken_pieces(drawn.drawn_as)));
  }
}

std::string place_of(const ImportRequest& request) {
  return request.curve ? request.curve->path.string()
                       : fmt::format("the reading at {:g} h", request.operating_hours);
}

/// Puts the reading among those of the folder, and checks that steel only goes.
void place_among_others(const Case& mill, const ImportRequest& request, ImportedReading& imported) {
  const fs::path file = request.folder / gauge_table_name;
  auto& rows = imported.table;
  if (fs::exists(file)) rows = read_gauge_rows(file);
  const auto same_hours = [&](const GaugeRow& row) {
    return row.operating_hours == request.operating_hours;
  };
  imported.replaces = std::erase_if(rows, same_hours) > 0;
  auto readings = gauge_readings(rows, file, mill.liner.sector);

  const auto later = std::find_if(rows.begin(), rows.end(), [&](const GaugeRow& row) {
    return row.operating_hours > request.operating_hours;
  });
  const auto index = later - rows.begin();
  std::vector<std::string> places;
  for (const auto& row : rows) places.push_back(fmt::format("{}:{}", file.string(), row.line));
  places.insert(places.begin() + index, place_of(request));
  readings.insert(readings.begin() + index, imported.reading);
  check_steel_goes(readings, places);

  const bool has_profile = imported.reading.profile.has_value();
  rows.insert(later,
              {request.operating_hours, has_profile ? std::nullopt : imported.reading.lifter_height,
               has_profile ? std::nullopt : imported.reading.plate_thickness,
               has_profile ? profile_name(request.operating_hours) : "", request.error});
}

}  // namespace

std::string profile_name(double operating_hours) {
  constexpr std::size_t digits_before_the_point = 7;
  const std::string hours = fmt::format("{}", operating_hours);
  const std::size_t digits = std::min(hours.find('.'), hours.size());
  const std::size_t missing = digits_before_the_point - std::min(digits, digits_before_the_point);
  return fmt::format("profile_{}{}h.csv", std::string(missing, '0'), hours);
}

ImportedReading prepare_reading(const Case& mill, const ImportRequest& request) {
  ImportedReading imported{
      {request.operating_hours, request.lifter_height, request.plate_thickness, {}, request.error},
      {},
      {},
      0,
      {},
      false,
      {}};
  if (request.curve) add_profile(mill, request, imported);
  check_under_new_liner(imported.reading, mill.liner, place_of(request));
  if (imported.reading.plate_thickness && *imported.reading.plate_thickness < 0.0)
    throw InputError(
        fmt::format("{}: the profile reaches {:.1f} mm below the shell; is it aligned?",
                    place_of(request), -1e3 * *imported.reading.plate_thickness));
  place_among_others(mill, request, imported);
  return imported;
}

void publish_reading(const ImportedReading& imported, const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed)
    throw DiskError(fmt::format("{}: cannot be made: {}", folder.string(), failed.message()));
  if (imported.reading.profile)
    publish(folder / profile_name(imported.reading.operating_hours),
            profile_csv(*imported.reading.profile));
  publish(folder / gauge_table_name, gauge_readings_csv(imported.table));
}

}  // namespace millwear::orchestrator
