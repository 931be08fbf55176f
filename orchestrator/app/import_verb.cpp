#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/base/number_or_null.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/verbs.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "orchestrator/gauge/gauge_import.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;

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

ImportRequest request_of(const Command& command, const Case& mill) {
  const ImportOptions& options = command.import;
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
                        .folder = gauge_folder(mill, command.readings)};
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

void import_verb(const Command& command) {
  const Case mill = read_case(command.case_file);
  const ImportRequest request = request_of(command, mill);
  const ImportedReading imported = prepare_reading(mill, request);
  publish_reading(imported, request.folder);
  if (command.form == OutputForm::json)
    print_json(request, imported);
  else
    print_text(request, imported);
}

}  // namespace millwear::orchestrator
