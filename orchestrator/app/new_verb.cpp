#include "orchestrator/app/new_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/text_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "mill/new_case/new_case.h"
#include "orchestrator/drawing/drawn_liner_reader.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

std::optional<double> metres(std::optional<double> millimetres) {
  if (!millimetres) return std::nullopt;
  return 1e-3 * *millimetres;
}

/// The drawing as the case file names it: from its own folder.
std::string name_from(const fs::path& case_file, const fs::path& drawing) {
  const std::string name =
      fs::relative(fs::absolute(drawing), fs::absolute(case_file).parent_path()).generic_string();
  const bool is_plain =
      std::ranges::all_of(name, [](unsigned char c) { return c >= ' ' && c != '"' && c != '\\'; });
  if (!is_plain)
    throw InputError(
        fmt::format("{}: a case file cannot name a drawing with a quote, a backslash "
                    "or a control character; rename it",
                    in_quotes(name)));
  return name;
}

/// Height of the drawn lifter [m].
double drawn_height(const NewOptions& options) {
  const double shell = 0.5 * options.shell_diameter;
  const double plate = metres(options.plate_mm).value_or(assumed_plate(options.shell_diameter));
  return lifter_height(read_drawn_liner({*options.drawing, {}, options.unit, {}, false},
                                        {shell, shell - plate, options.rows}));
}

NewCase wanted_of(const NewOptions& options) {
  NewCase wanted{options.common.case_file.stem().string(),
                 options.shell_diameter,
                 options.rows,
                 options.speed_rpm,
                 options.critical_fraction,
                 {},
                 options.filling,
                 options.ball_filling,
                 {},
                 {}};
  if (options.drawing) wanted.liner.drawing = name_from(options.common.case_file, *options.drawing);
  wanted.liner.unit = options.unit;
  wanted.liner.height = options.drawing ? drawn_height(options) : metres(options.height_mm);
  wanted.liner.top_width = metres(options.top_width_mm);
  wanted.liner.face_angle = options.face_angle_deg;
  wanted.liner.plate_thickness = metres(options.plate_mm);
  if (!options.balls.empty()) wanted.balls = size_shares(options.balls);
  if (!options.ore.empty()) wanted.ore = size_shares(options.ore);
  return wanted;
}

void check_usage(const NewOptions& options) {
  if (options.speed_rpm && options.critical_fraction)
    throw Failure(ExitCode::usage, "--speed-rpm and --critical both say the speed; give one");
  if (options.drawing && (options.height_mm || options.top_width_mm || options.face_angle_deg))
    throw Failure(ExitCode::usage,
                  "the drawing says the lifter's shape; leave --height-mm, --top-width-mm and "
                  "--face-angle-deg out");
  if (options.unit && !options.drawing)
    throw Failure(ExitCode::usage, "--unit is that of a drawing; give --from-drawing");
  const fs::path& file = options.common.case_file;
  if (fs::exists(file))
    throw InputError(
        fmt::format("{}: the file is there; delete it, or write another", file.string()));
  if (!fs::is_directory(fs::absolute(file).parent_path()))
    throw InputError(fmt::format("{}: there is no folder for it; make it first", file.string()));
}

std::size_t assumed_lines(std::string_view text) {
  constexpr std::string_view mark = "# assumed";
  std::size_t count = 0;
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1))
    ++count;
  return count;
}

void print_written(const NewOptions& options, const Case& mill, std::size_t assumed) {
  const std::string file = options.common.case_file.string();
  if (options.common.form == OutputForm::json) {
    const nlohmann::ordered_json written{{"case", file},
                                         {"lifter_height_m", lifter_height(mill.liner)},
                                         {"particles", totals(mill).particles},
                                         {"assumed", assumed}};
    fmt::print("{}\n", written.dump(1));
  } else if (options.common.verbosity != Verbosity::quiet) {
    fmt::print(
        "{0}: {1} lifters {2:.1f} mm high, {3} particles; {4} values are assumed, each with a "
        "comment\nnext: millwear check {0} --picture drawings\n      millwear run {0}\n",
        file, mill.liner.sector.rows, 1e3 * lifter_height(mill.liner), totals(mill).particles,
        assumed);
  }
}

}  // namespace

void add_options(CLI::App& verb, NewOptions& options) {
  std::map<std::string, LengthUnit> units;
  for (const LengthUnitName& name : length_units()) units.emplace(name.symbol, name.unit);
  verb.add_option("case", options.common.case_file, "The case file that is written")->required();
  add_output_options(verb, options.common);
  verb.add_option("--from-drawing", options.drawing, "DXF of one lifter from plate to plate");
  verb.add_option("--unit", options.unit, "Unit of the drawing: m, mm, cm, in or ft")
      ->transform(CLI::CheckedTransformer(units).description(""));
  verb.add_option("--shell-diameter", options.shell_diameter,
                  "Diameter inside the shell, under the liner [m]")
      ->required()
      ->check(CLI::Range(0.05, 50.0));
  verb.add_option("--rows", options.rows, "Lifters around the mill")
      ->required()
      ->check(CLI::Range(4, 1000));
  verb.add_option("--speed-rpm", options.speed_rpm, "Speed [1/min]");
  verb.add_option("--critical", options.critical_fraction,
                  "Speed as a share of critical; by default 0.75");
  verb.add_option("--height-mm", options.height_mm, "Height of the lifter, without a drawing");
  verb.add_option("--top-width-mm", options.top_width_mm, "Width of its top");
  verb.add_option("--face-angle-deg", options.face_angle_deg, "Angle of its faces off upright");
  verb.add_option("--plate-mm", options.plate_mm, "Thickness of the plate")
      ->check(CLI::PositiveNumber);
  verb.add_option("--filling", options.filling, "Total filling of the mill, as a share")
      ->required();
  verb.add_option("--ball-filling", options.ball_filling,
                  "Filling by balls, where there is ore too");
  verb.add_option("--balls", options.balls,
                  "Ball sizes, mm and percent retained: \"90:39.9,63:60.1\"");
  verb.add_option("--ore", options.ore, "The same of the ore");
}

void new_verb(const NewOptions& options) {
  check_usage(options);
  const fs::path& file = options.common.case_file;
  const std::string text = new_case_text(wanted_of(options));
  const Case mill = case_from_document(parse_case_document(text, file), read_drawn_liner);
  publish(file, text);
  print_written(options, mill, assumed_lines(text));
}

}  // namespace millwear::orchestrator
