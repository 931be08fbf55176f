#include "orchestrator/app/command_line.h"

#include <CLI/CLI.hpp>
#include <array>
#include <map>

#include "mill/base/failure.h"
#include "mill/base/version.h"

namespace millwear::orchestrator {
namespace {

constexpr int most_ranks = 100000;
constexpr double most_hours = 1e6;
constexpr double least_error_mm = 0.01;
constexpr double most_error_mm = 100.0;

struct VerbText {
  Verb verb;
  const char* name;
  const char* what;
  const char* examples;
};

constexpr std::array<VerbText, 12> verbs = {{
    {Verb::check, "check",
     "Check a case file and print what would be simulated: counts, filling, time step, cost",
     "  millwear check cases/pilot_mill/case.toml\n"
     "  millwear check cases/seed_mill_8m/case.toml --json"},
    {Verb::mesh, "mesh", "Write the liner's mesh (STL) and its section for CAD (STEP, DXF)",
     "  millwear mesh cases/pilot_mill/case.toml --out mesh\n"
     "  millwear mesh cases/pilot_mill/case.toml --profile worn.csv --out mesh"},
    {Verb::deck, "deck", "Write the mesh and the LIGGGHTS decks, to read or to run by hand",
     "  millwear deck cases/pilot_mill/case.toml --out deck\n"
     "  cd deck/cycle_000/mix && mpirun -np 2 liggghts -in deck.in"},
    {Verb::run, "run", "Wear the liner to its limit; the same command resumes what was stopped",
     "  millwear run cases/pilot_mill/case.toml\n"
     "  millwear run cases/pilot_mill/case.toml --out runs/try --ranks 2 --explain"},
    {Verb::status, "status", "Say how far a campaign is",
     "  millwear status cases/pilot_mill/case.toml"},
    {Verb::report, "report", "Write the result files and report.html of a campaign so far",
     "  millwear report cases/pilot_mill/case.toml --out runs/try"},
    {Verb::wear, "wear",
     "Put another wear law or coefficient to the loads that a campaign keeps, without any DEM",
     "  cp cases/pilot_mill/case.toml other_law.toml   # and change the laws in its [wear]\n"
     "  millwear wear other_law.toml --out runs/pilot_mill\n"
     "  millwear wear other_law.toml --out runs/pilot_mill --csv rates.csv --json"},
    {Verb::import, "import",
     "Bring in what a gauge or a scan told of the worn liner: gauge/gauge_readings.csv",
     "  millwear import my_mill.toml scan.csv --hours 5112 --unit mm\n"
     "  millwear import my_mill.toml drawing.dxf --hours 5448 --layer LINER --error-mm 0.5\n"
     "  millwear import my_mill.toml --hours 6312 --height-mm 56"},
    {Verb::compare, "compare",
     "Compare a campaign with the gauge readings, or two profiles with each other",
     "  millwear compare my_mill.toml\n"
     "  millwear compare my_mill.toml --out runs/try --csv comparison.csv\n"
     "  millwear compare my_mill.toml --calibrate-until 5112 --plot calibrated.png\n"
     "  millwear compare my_mill.toml --profiles scanned.csv predicted.csv"},
    {Verb::calibrate, "calibrate",
     "Find the coefficients of the wear laws from measured heights and profiles, along the liners "
     "and loads that a campaign keeps, without any DEM",
     "  millwear calibrate cases/pilot_mill/case.toml   # reads cases/pilot_mill/gauge\n"
     "  millwear calibrate two_laws.toml --out runs/pilot_mill --readings measured --until 4000"},
    {Verb::tune, "tune",
     "Find the neighbour skin and the split among ranks that LIGGGHTS is fastest with, by a short "
     "trial on the real charge",
     "  millwear tune my_mill.toml                  # takes the mixed charge in runs/NAME, if any\n"
     "  millwear tune my_mill.toml --out runs/try --ranks 2 --json"},
    {Verb::postprocess, "postprocess",
     "Turn the dumps of a LIGGGHTS run of your own into the load on the liner, the worn profile "
     "and "
     "the next mesh",
     "  millwear postprocess my_mill.toml --contacts contacts.dump --particles particles.dump \\\n"
     "    --timestep 2e-5 --out worn\n"
     "  millwear postprocess my_mill.toml --contacts c.dump --particles p.dump --timestep 2e-5 \\\n"
     "    --profile worn.csv --mesh liner.stl --after 200000 --hours 500 --out worn_2"},
}};

void add_common_options(CLI::App& verb, Command& command) {
  verb.add_option("case", command.case_file, "The case file (docs/case_file.md)")->required();
  if (verb.get_name() == "tune")
    verb.add_option("--out", command.out,
                    "Folder of a campaign whose mixed charge is taken if it has one; by default "
                    "runs/NAME");
  else if (verb.get_name() == "postprocess")
    verb.add_option("--out", command.out, "New folder of the results; by default postprocess/NAME");
  else if (verb.get_name() != "import")
    verb.add_option("--out", command.out, "Folder of the results; by default runs/NAME");
  verb.add_flag_callback(
      "--json", [&] { command.form = OutputForm::json; }, "Print results as JSON");
  verb.add_flag_callback(
      "-q,--quiet", [&] { command.verbosity = Verbosity::quiet; }, "Print errors only");
  verb.add_flag_callback(
      "-v,--verbose", [&] { command.verbosity = Verbosity::verbose; }, "Print more");
}

void add_import_options(CLI::App& verb, ImportOptions& import) {
  const std::map<std::string, LengthUnit> units{{"m", LengthUnit::metre},
                                                {"mm", LengthUnit::millimetre}};
  const std::map<std::string, AlignmentMode> modes{
      {"none", AlignmentMode::none}, {"ends", AlignmentMode::ends}, {"fit", AlignmentMode::fit}};
  verb.add_option("file", import.curve, "CSV (xi_m,eta_m or x,y) or DXF of the worn profile");
  verb.add_option("--hours", import.hours, "Operating hours since the liner was new")
      ->required()
      ->check(CLI::Range(0.0, most_hours));
  verb.add_option("--unit", import.unit, "Unit of x and y, or of a DXF: m or mm")
      ->transform(CLI::CheckedTransformer(units).description(""));
  verb.add_option("--layer", import.layer, "Layer of a DXF that the profile is on");
  verb.add_option("--align", import.align,
                  "none: it is in the master frame (xi_m,eta_m); ends: by its two ends on the "
                  "plate; fit: by its unworn parts (x,y and DXF)")
      ->transform(CLI::CheckedTransformer(modes).description(""));
  verb.add_flag("--mirror", import.mirror, "The profile was seen from the other end of the mill");
  verb.add_option("--reference", import.reference,
                  "CSV of a profile to align with, in place of the new liner");
  verb.add_option("--error-mm", import.error_mm, "Standard error of a length; by default 1 mm")
      ->check(CLI::Range(least_error_mm, most_error_mm));
  verb.add_option("--height-mm", import.height_mm, "A lifter height, in place of a profile");
  verb.add_option("--plate-mm", import.plate_mm,
                  "Steel over the shell; with --align ends that under the profile's ends");
}

void add_compare_options(CLI::App& verb, Command& command) {
  const std::map<std::string, GaugeOn> gauges{{"new-plate", GaugeOn::new_plate},
                                              {"plate", GaugeOn::plate}};
  verb.add_option("--csv", command.csv, "Write the comparison with the readings as a table");
  verb.add_option("--profiles", command.compared_profiles,
                  "Two profiles (CSV) to compare, in place of the campaign and the readings")
      ->expected(2);
  verb.add_option("--calibrate-until", command.calibrate_until,
                  "Calibrate the campaign's hours on the heights read up to these operating hours "
                  "and predict the later ones; by default the case's [gauge] "
                  "calibrate_until_hours; 0 for not at all")
      ->check(CLI::Range(0.0, most_hours));
  verb.add_option("--gauge-on", command.gauge_on,
                  "With --calibrate-until: what the heights were read from: new-plate, where the "
                  "plate was when new (by default), or plate, the worn plate that a gauge rests on")
      ->transform(CLI::CheckedTransformer(gauges).description(""));
  verb.add_option("--plot", command.plot, "With --calibrate-until: draw it (PNG) with gnuplot");
}

void add_postprocess_options(CLI::App& verb, Command& command) {
  PostprocessOptions& options = command.postprocess;
  HandRun& run = options.run;
  verb.add_option("--contacts", run.contacts,
                  "Dump of the wall contacts (`dump local` of a `compute wall/gran/local`)")
      ->required();
  verb.add_option(
          "--particles", run.particles,
          "Dump of the particles (`dump custom`: id type radius x y z vx vy vz omegax omegay "
          "omegaz), of the same steps")
      ->required();
  verb.add_option("--timestep", run.time_step, "The deck's `timestep`, in seconds")
      ->required()
      ->check(CLI::PositiveNumber);
  verb.add_option("--contact-keywords", run.contact_keywords,
                  "Keywords of the deck's compute wall/gran/local, in quotes; by default \"" +
                      run.contact_keywords + "\"");
  verb.add_option("--profile", command.profile,
                  "CSV of the profile (xi_m,eta_m) that the deck's mesh follows; by default the "
                  "case's new one");
  verb.add_option("--mesh", run.mesh,
                  "STL that the deck reads; by default the one that `millwear mesh` writes");
  verb.add_option("--after", run.after,
                  "The measurement begins with the first snapshot from this step on")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--until", run.until, "... and ends with the last snapshot up to this step")
      ->check(CLI::PositiveNumber);
  verb.add_option(
          "--angle-deg", options.angle_deg,
          "Angle of the liner at --angle-step, along the rotation; 0 where a lifter's middle "
          "stands at six o'clock, as in the mesh of `millwear mesh`")
      ->check(CLI::Range(-360.0, 360.0));
  verb.add_option("--angle-step", run.angle_step,
                  "Step with which the liner begins to turn; by default 0")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--turns-about", run.turns_about,
                  "Axis of the deck that the mill turns about, by the right-hand rule: +y by "
                  "default, or +x, -x, -y, +z, -z");
  verb.add_option("--gravity", run.gravity, "Axis along which gravity acts: -z by default");
  verb.add_option("--hours", options.hours,
                  "Wear the liner for so many hours of milling at most; by default until the load "
                  "is spent or a limit is met")
      ->check(CLI::Range(1e-6, most_hours));
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, const char* const* argv) {
  CLI::App app(
      "Predicts how the lifters of a tumbling mill wear: gmsh meshes, LIGGGHTS loads, a "
      "wear law, again and again until the liner is worn out.",
      "millwear");
  app.set_version_flag("--version", program_version());
  app.require_subcommand(1);
  app.footer(
      "\nStart with:\n  millwear check cases/pilot_mill/case.toml\n"
      "  millwear run cases/pilot_mill/case.toml\n\n"
      "Exit codes: 0 ok, 1 internal, 2 usage, 3 bad case file, 4 external program failed,\n"
      "5 result rejected, 6 disk, 7 locked, 130/143 interrupted");
  Command command{.verb = Verb::check,
                  .case_file = {},
                  .out = {},
                  .form = OutputForm::text,
                  .verbosity = Verbosity::normal,
                  .dry_run = false,
                  .explain = false,
                  .ranks = {},
                  .profile = {},
                  .csv = {}};
  for (const auto& text : verbs) {
    CLI::App* const verb = app.add_subcommand(text.name, text.what);
    verb->footer(std::string("\nExamples:\n") + text.examples);
    verb->callback([&command, which = text.verb] { command.verb = which; });
    add_common_options(*verb, command);
    if (text.verb == Verb::run) {
      verb->add_flag("--dry-run", command.dry_run, "Say which stages would run, and run none");
      verb->add_flag("--explain", command.explain, "Say why each stage runs");
    }
    if (text.verb == Verb::run || text.verb == Verb::deck || text.verb == Verb::tune)
      verb->add_option("--ranks", command.ranks, "MPI ranks, instead of the case's")
          ->check(CLI::Range(1, most_ranks));
    if (text.verb == Verb::mesh || text.verb == Verb::deck)
      verb->add_option("--profile", command.profile,
                       "CSV of a worn profile (xi_m,eta_m) in place of the new one");
    if (text.verb == Verb::postprocess) add_postprocess_options(*verb, command);
    if (text.verb == Verb::wear)
      verb->add_option("--csv", command.csv, "Write the depth rate by cycle, mechanism and bin");
    if (text.verb == Verb::import) add_import_options(*verb, command.import);
    if (text.verb == Verb::compare) add_compare_options(*verb, command);
    if (text.verb == Verb::import || text.verb == Verb::compare || text.verb == Verb::report ||
        text.verb == Verb::calibrate)
      verb->add_option("--readings", command.readings,
                       "Folder of the gauge readings; by default `gauge` beside the case file");
    if (text.verb == Verb::calibrate) {
      verb->add_option("--until", command.until,
                       "Fit to the readings up to these operating hours and predict the later ones")
          ->check(CLI::PositiveNumber);
      verb->add_option("--csv", command.csv, "Write the readings beside what is fitted");
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    const int code = app.exit(problem);
    return {std::nullopt, code == 0 ? 0 : static_cast<int>(ExitCode::usage)};
  }
  return {command, 0};
}

}  // namespace millwear::orchestrator
