#include "orchestrator/app/import_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/base/number_or_null.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "orchestrator/gauge/gauge_import.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double least_error_mm = 0.01;
constexpr double most_error_mm = 100.0;
constexpr double metres_per_millimetre = 1e-3;

[[noreturn]] void wrong_usage(const std::string& what) { throw Failure(ExitCode::usage, what); }

void check_usage(const ImportOptions& options) {
  if (!options.curve && !options.height_mm && !options.plate_mm)
    wrong_usage("give the file of a profile, or a reading with --height-mm or --plate-mm");
  if (options.curve && options.height_mm)
    wrong_usage("a profile tells the lifter's height itself; leave --height-mm out");
  if (options.curve && options.plate_mm && options.align != AlignmentMode::ends)
    wrong_usage(
        "with a profile, --plate-mm says where its ends lie; it goes with --align ends only");
  if (options.reference && options.align == AlignmentMode::none)
    wrong_usage("--reference goes with --align fit or ends");
  if (!options.curve && (options.mirror || options.unit || options.layer || options.reference ||
                         options.align != AlignmentMode::by_file))
    wrong_usage("--align, --mirror, --unit, --layer and --reference go with the file of a profile");
}

/// The reading's own files must not take the place of the file that it is read from.
void check_is_not_overwritten(const ImportOptions& options, const ImportRequest& request) {
  if (!fs::is_directory(request.folder)) return;
  for (const auto& name : {profile_name(options.hours), std::string(gauge_table_name)})
    check_output_file("--readings", request.folder / name, {*options.curve});
}

ImportRequest request_of(const ImportOptions& options, const Case& mill) {
  check_usage(options);
  const auto metres = [](std::optional<double> millimetres) -> std::optional<double> {
    if (!millimetres) return std::nullopt;
    return metres_per_millimetre * *millimetres;
  };
  ImportRequest request{.curve = {},
                        .operating_hours = options.hours,
                        .error = metres_per_millimetre * options.error_mm,
                        .align = options.align,
                        .mirror = options.mirror,
                        .lifter_height = metres(options.height_mm),
                        .plate_thickness = metres(options.plate_mm),
                        .reference = options.reference,
                        .folder = gauge_folder(mill, options.readings)};
  if (options.curve) request.curve = CurveFile{*options.curve, options.unit, options.layer};
  return request;
}

void print_json(const ImportRequest& request, const ImportedReading& imported) {
  const GaugeReading& reading = imported.reading;
  Json json{{"operating_hours", reading.operating_hours},
            {"lifter_height_m", number_or_null(reading.lifter_height)},
            {"plate_thickness_m", number_or_null(reading.plate_thickness)},
            {"error_m", reading.error},
            {"replaced", imported.replaces},
            {"table", (request.folder / gauge_table_name).string()},
            {"readings", imported.table.size()}};
  if (reading.profile) {
    json["profile_csv"] = (request.folder / profile_name(reading.operating_hours)).string();
    json["points"] = imported.points;
    json["left_out"] = imported.left_out;
    json["nodes"] = reading.profile->nodes.size();
    json["face_angle_rad"] = leading_face_angle(*reading.profile);
  }
  if (imported.alignment)
    json["alignment"] = {
        {"angle_rad", imported.alignment->motion.angle},
        {"shift_m", {imported.alignment->motion.shift.x(), imported.alignment->motion.shift.y()}},
        {"reversed", imported.alignment->reversed}};
  if (imported.fit)
    json["fit"] = {{"rms_m", imported.fit->rms},
                   {"used_share", imported.fit->used_share},
                   {"hold", imported.fit->hold}};
  fmt::print("{}\n", json.dump(1));
}

void print_alignment(const ImportedReading& imported) {
  const auto& motion = imported.alignment->motion;
  fmt::print(
      "Profile   {} points, {} nodes kept; turned by {:.2f} deg, moved by ({:.1f}, {:.1f}) "
      "mm{}\n",
      imported.points, imported.reading.profile->nodes.size(), degrees_per_radian * motion.angle,
      1e3 * motion.shift.x(), 1e3 * motion.shift.y(),
      imported.alignment->reversed ? ", its order reversed" : "");
  if (imported.fit)
    fmt::print(
        "Fit       {:.0f} % of it lies on the reference, {:.2f} mm (rms) from it; the rest "
        "is worn\n",
        100.0 * imported.fit->used_share, 1e3 * imported.fit->rms);
}

void print_text(const ImportRequest& request, const ImportedReading& imported) {
  const GaugeReading& reading = imported.reading;
  for (const std::string& left : imported.left_out) fmt::print("Left out  {}\n", left);
  if (imported.alignment) print_alignment(imported);
  fmt::print("Reading   at {:g} h:", reading.operating_hours);
  if (reading.lifter_height) fmt::print(" lifter {:.1f} mm high,", 1e3 * *reading.lifter_height);
  if (reading.profile)
    fmt::print(" leading face {:.1f} deg,",
               degrees_per_radian * leading_face_angle(*reading.profile));
  if (reading.plate_thickness) fmt::print(" plate {:.1f} mm,", 1e3 * *reading.plate_thickness);
  fmt::print(" error {:g} mm\n{} {} in {} ({} readings)\n", 1e3 * reading.error,
             imported.replaces ? "Replaced  the reading of these hours" : "Added     it",
             reading.profile ? "with " + profile_name(reading.operating_hours) : "",
             (request.folder / gauge_table_name).string(), imported.table.size());
}

}  // namespace

void add_options(CLI::App& verb, ImportOptions& options) {
  std::map<std::string, LengthUnit> units;
  for (const LengthUnitName& name : length_units()) units.emplace(name.symbol, name.unit);
  const std::map<std::string, AlignmentMode> modes{
      {"none", AlignmentMode::none}, {"ends", AlignmentMode::ends}, {"fit", AlignmentMode::fit}};
  add_options(verb, options.common);
  add_readings_folder(verb, options.readings);
  verb.add_option("file", options.curve, "CSV (xi_m,eta_m or x,y) or DXF of the worn profile");
  verb.add_option("--hours", options.hours, "Operating hours since the liner was new")
      ->required()
      ->check(CLI::Range(0.0, most_hours));
  verb.add_option("--unit", options.unit, "Unit of x and y, or of a DXF: m, mm, cm, in or ft")
      ->transform(CLI::CheckedTransformer(units).description(""));
  verb.add_option("--layer", options.layer, "Layer of a DXF that the profile is on");
  verb.add_option("--align", options.align,
                  "none: it is in the master frame (xi_m,eta_m); ends: by its two ends on the "
                  "plate; fit: by its unworn parts (x,y and DXF)")
      ->transform(CLI::CheckedTransformer(modes).description(""));
  verb.add_flag("--mirror", options.mirror, "The profile was seen from the other end of the mill");
  verb.add_option("--reference", options.reference,
                  "CSV of a profile to align with, in place of the new liner");
  verb.add_option("--error-mm", options.error_mm, "Standard error of a length; by default 1 mm")
      ->check(CLI::Range(least_error_mm, most_error_mm));
  verb.add_option("--height-mm", options.height_mm, "A lifter height, in place of a profile");
  verb.add_option("--plate-mm", options.plate_mm,
                  "Steel over the shell; with --align ends that under the profile's ends");
}

void import_verb(const ImportOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const ImportRequest request = request_of(options, mill);
  const ImportedReading imported = prepare_reading(mill, request);
  if (options.curve) check_is_not_overwritten(options, request);
  publish_reading(imported, request.folder);
  if (options.common.form == OutputForm::json)
    print_json(request, imported);
  else
    print_text(request, imported);
}

}  // namespace millwear::orchestrator
