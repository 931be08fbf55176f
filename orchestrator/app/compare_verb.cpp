#include "orchestrator/app/compare_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/base/number_or_null.h"
#include "mill/base/published_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/compare_campaigns.h"
#include "orchestrator/calibration/course_calibration.h"
#include "orchestrator/calibration/course_comparison.h"
#include "orchestrator/calibration/repeated_comparison.h"
#include "orchestrator/calibration/repeated_courses.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/campaign/run_folder.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/gauge/gauge_comparison.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "orchestrator/pictures/course_plot.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using wear::ProfileDifference;

constexpr double square_centimetres = 1e4;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Json json_of(const ProfileDifference& difference) {
  return {{"lifter_height_m", difference.lifter_height},
          {"face_angle_rad", difference.face_angle},
          {"plate_thickness_m", difference.plate_thickness},
          {"signed_area_m2", difference.signed_area},
          {"absolute_area_m2", difference.absolute_area},
          {"rms_distance_m", difference.rms_distance},
          {"hausdorff_m", difference.hausdorff}};
}

Json json_of(const GaugeReading& reading) {
  return {{"lifter_height_m", number_or_null(reading.lifter_height)},
          {"plate_thickness_m", number_or_null(reading.plate_thickness)},
          {"face_angle_rad",
           reading.profile ? Json(leading_face_angle(*reading.profile)) : Json(nullptr)},
          {"error_m", reading.error}};
}

Json json_of(const std::vector<ReadingComparison>& comparisons) {
  Json readings = Json::array();
  for (const auto& [measured, predicted, difference] : comparisons) {
    Json reading{{"operating_hours", measured.operating_hours}, {"measured", json_of(measured)}};
    reading["predicted"] = predicted ? Json{{"lifter_height_m", predicted->lifter_height},
                                            {"plate_thickness_m", predicted->plate_thickness},
                                            {"face_angle_rad", predicted->face_angle},
                                            {"profile_hours", predicted->profile_hours}}
                                     : Json(nullptr);
    reading["profile_difference"] = difference ? json_of(*difference) : Json(nullptr);
    readings.push_back(std::move(reading));
  }
  return {{"readings", readings}, {"rms_height_m", number_or_null(rms_of_heights(comparisons))}};
}

/// A number in a column of nine, or a dash for NaN.
std::string cell(double value, double per_unit) {
  return std::isnan(value) ? fmt::format("{:>9}", "-") : fmt::format("{:9.1f}", per_unit * value);
}

double of(const std::optional<Prediction>& predicted, double Prediction::*value) {
  return predicted ? (*predicted).*value : nan;
}

double of(const std::optional<ProfileDifference>& difference, double ProfileDifference::*value) {
  return difference ? (*difference).*value : nan;
}

void print_row(const ReadingComparison& row) {
  const GaugeReading& measured = row.measured;
  const double height = measured.lifter_height.value_or(nan);
  const double off = of(row.predicted, &Prediction::lifter_height) - height;
  const double face = measured.profile ? leading_face_angle(*measured.profile) : nan;
  const auto predicted = [&](double Prediction::*value, double per_unit) {
    return cell(of(row.predicted, value), per_unit);
  };
  const auto between = [&](double ProfileDifference::*value, double per_unit) {
    return cell(of(row.difference, value), per_unit);
  };
  fmt::print("{:9.1f} {} {} {} {}  {} {}  {} {}  {} {}  {} {}  {}\n", measured.operating_hours,
             cell(height, 1e3), predicted(&Prediction::lifter_height, 1e3), cell(off, 1e3),
             cell(off / measured.error, 1.0), cell(face, degrees_per_radian),
             predicted(&Prediction::face_angle, degrees_per_radian),
             cell(measured.plate_thickness.value_or(nan), 1e3),
             predicted(&Prediction::plate_thickness, 1e3),
             between(&ProfileDifference::signed_area, square_centimetres),
             between(&ProfileDifference::absolute_area, square_centimetres),
             between(&ProfileDifference::rms_distance, 1e3),
             between(&ProfileDifference::hausdorff, 1e3),
             row.difference ? predicted(&Prediction::profile_hours, 1.0) : cell(nan, 1.0));
}

void print_text(const std::vector<ReadingComparison>& comparisons) {
  fmt::print("{:9} {:<39}  {:<19}  {:<19}  {:<19}  {:<19}\n", "", "lifter height [mm]",
             "leading face [deg]", "plate [mm]", "section [cm2]", "distance [mm]");
  fmt::print(
      "{:>9} {:>9} {:>9} {:>9} {:>9}  {:>9} {:>9}  {:>9} {:>9}  {:>9} {:>9}  {:>9} {:>9}  "
      "{:>9}\n",
      "hours", "measured", "predicted", "diff", "in errors", "measured", "predicted", "measured",
      "predicted", "signed", "absolute", "rms", "largest", "step at");
  for (const auto& row : comparisons) print_row(row);
  const double rms = rms_of_heights(comparisons);
  if (std::isfinite(rms))
    fmt::print("Heights differ by {:.1f} mm (rms). Differences are predicted less measured.\n",
               1e3 * rms);
  else
    fmt::print("No reading lies within the hours of the campaign.\n");
}

void print_text(const ProfileDifference& difference) {
  fmt::print(
      "Lifter height     {:+.2f} mm\nLeading face      {:+.2f} deg\nPlate             {:+.2f} mm\n"
      "Section, signed   {:+.2f} cm2\nSection, absolute {:.2f} cm2\n"
      "Distance, rms     {:.2f} mm\nDistance, largest {:.2f} mm\n"
      "Differences are the first less the second.\n",
      1e3 * difference.lifter_height, degrees_per_radian * difference.face_angle,
      1e3 * difference.plate_thickness, square_centimetres * difference.signed_area,
      square_centimetres * difference.absolute_area, 1e3 * difference.rms_distance,
      1e3 * difference.hausdorff);
}

/// How far to calibrate [h]; none where neither the command nor the case says.
std::optional<double> calibrate_until(const CompareOptions& options, const Case& mill) {
  const auto until = options.calibrate_until ? options.calibrate_until : mill.gauge.calibrate_until;
  return until == 0.0 ? std::nullopt : until;
}

CalibratedCourse course_in(const fs::path& results, const CompareOptions& options, const Case& mill,
                           const std::vector<GaugeReading>& readings, double until) {
  CampaignCourse campaign{read_history_csv(results / "history.csv"), {}};
  if (const auto replicates = results / "replicates.csv"; fs::exists(replicates))
    campaign.replicates = read_replicates_csv(replicates);
  return calibrated_course(mill, campaign, readings,
                           {until, options.gauge_on.value_or(GaugeOn::new_plate)});
}

void compare_calibrated(const CompareOptions& options, const CalibratedCourse& course) {
  if (options.csv) publish(*options.csv, course_csv(course));
  if (options.plot) publish(*options.plot, course_png({course}));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", course_json(course));
  else
    fmt::print("{}", course_text(course));
}

/// Several campaigns that differ in the seed, side by side.
void compare_repeats(const CompareOptions& options, const Case& mill,
                     const std::vector<GaugeReading>& readings, double until) {
  std::vector<Case> cases;
  std::vector<CalibratedCourse> courses;
  std::vector<std::uint64_t> seeds;
  for (const fs::path& out : options.outs) {
    const fs::path results = results_of(mill, {out});
    cases.push_back(read_case(RunFolder{out}.locked_case()));
    seeds.push_back(cases.back().dem.seed);
    courses.push_back(course_in(results, options, mill, readings, until));
  }
  check_repeats(cases, options.outs);
  const RepeatedCourses repeats = repeated_courses(std::move(courses), std::move(seeds));
  if (options.csv) publish(*options.csv, repeated_csv(repeats));
  if (options.plot) publish(*options.plot, course_png(repeats.courses));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", repeated_json(repeats));
  else
    fmt::print("{}", repeated_text(repeats));
}

void compare_as_run(const CompareOptions& options, const Case& mill, const fs::path& results,
                    const std::vector<GaugeReading>& readings) {
  const auto comparisons =
      compare_with(readings, read_history_csv(results / "history.csv"),
                   read_profiles_csv(results / "profiles.csv"), mill.liner.sector);
  if (options.csv) publish(*options.csv, comparison_csv(comparisons));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", json_of(comparisons).dump(1));
  else
    print_text(comparisons);
}

/// Throws Failure (usage) where an option is of the other kind of comparison.
void check_kind(const CompareOptions& options) {
  const bool of_case = !options.outs.empty() || options.csv || options.readings ||
                       !options.compared_profiles.empty() || options.calibrate_until ||
                       options.gauge_on || options.plot;
  if (of_case && !options.campaigns.empty())
    throw Failure(ExitCode::usage,
                  "folders of campaigns are compared with --page and --json alone; the other "
                  "options are for a case and its readings");
  if (options.page && options.campaigns.empty())
    throw Failure(ExitCode::usage, "--page is for two or more folders of campaigns; name them");
}

/// Throws Failure (usage) where an option asks for a calibration and there is none.
void check_usage(const CompareOptions& options, const Case& mill) {
  if (options.outs.size() > 1 && !calibrate_until(options, mill))
    throw Failure(ExitCode::usage,
                  "several campaigns (--out) are compared with calibrated hours; add "
                  "--calibrate-until HOURS, or name one");
  if (!options.gauge_on && !options.plot && !options.calibrate_until) return;
  if (!options.compared_profiles.empty())
    throw Failure(ExitCode::usage,
                  "--profiles compares two profiles alone; leave --calibrate-until, --gauge-on and "
                  "--plot out");
  if ((options.gauge_on || options.plot) && !calibrate_until(options, mill))
    throw Failure(ExitCode::usage,
                  "--gauge-on and --plot are for calibrated hours; add --calibrate-until HOURS, or "
                  "`calibrate_until_hours` in the case's [gauge]");
}

void check_outputs(const CompareOptions& options) {
  if (options.csv) check_output_file("--csv", *options.csv, {options.common.case_file});
  if (options.plot)
    check_output_file("--plot", *options.plot,
                      {options.common.case_file, options.csv.value_or(fs::path{})});
}

void compare_campaign(const CompareOptions& options, const Case& mill) {
  check_outputs(options);
  const auto until = calibrate_until(options, mill);
  const auto readings = needed_readings_in(gauge_folder(mill, options.readings), mill);
  if (options.outs.size() > 1) {
    compare_repeats(options, mill, readings, *until);
    return;
  }
  const RunFolder folder =
      run_folder_of(mill, options.outs.empty() ? fs::path{} : options.outs.front());
  const fs::path results = results_of(mill, folder);
  if (until)
    compare_calibrated(options, course_in(results, options, mill, readings, *until));
  else
    compare_as_run(options, mill, results, readings);
}

void compare_profiles(const CompareOptions& options, const Case& mill) {
  const auto& sector = mill.liner.sector;
  const ProfileDifference difference =
      wear::compare(read_profile_csv(options.compared_profiles.at(0), sector),
                    read_profile_csv(options.compared_profiles.at(1), sector));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", json_of(difference).dump(1));
  else
    print_text(difference);
}

}  // namespace

void add_options(CLI::App& verb, CompareOptions& options) {
  const std::map<std::string, GaugeOn> gauges{{"new-plate", GaugeOn::new_plate},
                                              {"plate", GaugeOn::plate}};
  verb.add_option_function<std::vector<std::filesystem::path>>(
          "case",
          [&](const auto& named) {
            options.common.case_file = named.front();
            if (named.size() > 1) options.campaigns = named;
          },
          "The case file (docs/case_file.md); or two or more folders of campaigns, of any cases, "
          "for a page that shows them side by side")
      ->required();
  add_output_options(verb, options.common);
  verb.add_option("--page", options.page,
                  "With folders of campaigns: the page; by default comparison.html")
      ->type_name("FILE");
  verb.add_option("--out", options.outs,
                  "Folder of the campaign; by default runs/NAME. Given more than once: campaigns "
                  "that differ in the seed, side by side with their mean and scatter")
      ->allow_extra_args(false);
  add_readings_folder(verb, options.readings);
  add_csv(verb, options.csv, "Write the comparison with the readings as a table");
  verb.add_option("--profiles", options.compared_profiles,
                  "Two profiles (CSV) to compare, in place of the campaign and the readings")
      ->expected(2);
  verb.add_option("--calibrate-until", options.calibrate_until,
                  "Calibrate the campaign's hours on the heights read up to these operating hours "
                  "and predict the later ones; by default the case's [gauge] "
                  "calibrate_until_hours; 0 for not at all")
      ->check(CLI::Range(0.0, most_hours));
  verb.add_option("--gauge-on", options.gauge_on,
                  "With --calibrate-until: what the heights were read from: new-plate, where the "
                  "plate was when new (by default), or plate, the worn plate that a gauge rests on")
      ->transform(CLI::CheckedTransformer(gauges).description(""));
  verb.add_option("--plot", options.plot, "With --calibrate-until: draw it (PNG) with gnuplot");
}

void compare_verb(const CompareOptions& options) {
  check_kind(options);
  if (!options.campaigns.empty()) {
    compare_campaigns(options.campaigns, options.page, options.common.form);
    return;
  }
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  check_usage(options, mill);
  if (options.compared_profiles.empty())
    compare_campaign(options, mill);
  else
    compare_profiles(options, mill);
}

}  // namespace millwear::orchestrator
