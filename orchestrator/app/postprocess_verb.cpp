#include "orchestrator/app/postprocess_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "mill/base/constants.h"
#include "mill/base/number_or_null.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/liner_choice.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/postprocess/postprocess_dumps.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

std::string spoken(wear::EvolutionEnd end) {
  switch (end) {
    case wear::EvolutionEnd::load_spent:
      return "the load is spent: measure the next one on this liner";
    case wear::EvolutionEnd::time_reached:
      return "the time asked for";
    case wear::EvolutionEnd::height_limit:
      return "the lifter is worn out";
    case wear::EvolutionEnd::plate_limit:
      return "the plate is worn out";
  }
  throw std::logic_error("an end of no kind");
}

nlohmann::json json_of(const PostprocessedDumps& result, const fs::path& out) {
  return {{"folder", out.string()},
          {"first_step", result.first_step},
          {"last_step", result.last_step},
          {"samples", result.samples},
          {"wall_contacts", result.contacts},
          {"measured_s", result.measured},
          {"rejected_share", result.rejected_share},
          {"volume_rate_m3_per_m_h", result.section_rate * seconds_per_hour},
          {"peak_relative_error", number_or_null(result.peak_error)},
          {"hours", result.milled / seconds_per_hour},
          {"end", wear::name_of(result.end)},
          {"lifter_height_m", lifter_height(result.worn)},
          {"plate_thickness_m", plate_thickness(result.worn)}};
}

void print_text(const PostprocessedDumps& result, const fs::path& out) {
  fmt::print("{} samples from step {} to {}: {:.4g} s, {} wall contacts, {:.2g} % off the liner\n",
             result.samples, result.first_step, result.last_step, result.measured, result.contacts,
             100.0 * result.rejected_share);
  fmt::print(
      "a lifter loses {:.3g} m3 per metre and hour; at its peaks the rate is known to {:.2g} %\n",
      result.section_rate * seconds_per_hour, 100.0 * result.peak_error);
  fmt::print("worn for {:.4g} h ({}): lifter {:.1f} mm high, plate {:.1f} mm thick\n",
             result.milled / seconds_per_hour, spoken(result.end), 1e3 * lifter_height(result.worn),
             1e3 * plate_thickness(result.worn));
  fmt::print(
      "load.h5, steps.json, profile.csv, liner.stl, profile.step, profile.dxf and mesh.json "
      "are in {}\n",
      out.string());
}

}  // namespace

void add_options(CLI::App& verb, PostprocessOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--out", options.out, "New folder of the results; by default postprocess/NAME");
  verb.add_option("--contacts", options.run.contacts,
                  "Dump of the wall contacts (`dump local` of a `compute wall/gran/local`)")
      ->required();
  verb.add_option(
          "--particles", options.run.particles,
          "Dump of the particles (`dump custom`: id type radius x y z vx vy vz omegax omegay "
          "omegaz), of the same steps")
      ->required();
  verb.add_option("--timestep", options.run.time_step, "The deck's `timestep`, in seconds")
      ->required()
      ->check(CLI::PositiveNumber);
  verb.add_option("--contact-keywords", options.run.contact_keywords,
                  "Keywords of the deck's compute wall/gran/local, in quotes; by default \"" +
                      options.run.contact_keywords + "\"");
  verb.add_option("--profile", options.profile,
                  "CSV of the profile (xi_m,eta_m) that the deck's mesh follows; by default the "
                  "case's new one");
  verb.add_option("--mesh", options.run.mesh,
                  "STL that the deck reads; by default the one that `millwear mesh` writes");
  verb.add_option("--after", options.run.after,
                  "The measurement begins with the first snapshot from this step on")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--until", options.run.until,
                  "... and ends with the last snapshot up to this step")
      ->check(CLI::PositiveNumber);
  verb.add_option(
          "--angle-deg", options.angle_deg,
          "Angle of the liner at --angle-step, along the rotation; 0 where a lifter's middle "
          "stands at six o'clock, as in the mesh of `millwear mesh`")
      ->check(CLI::Range(-360.0, 360.0));
  verb.add_option("--angle-step", options.run.angle_step,
                  "Step with which the liner begins to turn; by default 0")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--turns-about", options.run.turns_about,
                  "Axis of the deck that the mill turns about, by the right-hand rule: +y by "
                  "default, or +x, -x, -y, +z, -z");
  verb.add_option("--gravity", options.run.gravity, "Axis along which gravity acts: -z by default");
  verb.add_option("--hours", options.hours,
                  "Wear the liner for so many hours of milling at most; by default until the load "
                  "is spent or a limit is met")
      ->check(CLI::Range(1e-6, most_hours));
}

void postprocess_verb(const PostprocessOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const LinerProfile liner = case_with_profile(options.common, options.profile).liner;
  HandRun run = options.run;
  run.angle = options.angle_deg * radians_per_degree;
  const fs::path out = folder_or_default(options.out, "postprocess", mill);
  check_output_folder("--out", out);
  const double longest =
      options.hours ? *options.hours * seconds_per_hour : std::numeric_limits<double>::infinity();
  const PostprocessedDumps result = postprocess_dumps(mill, liner, run, out, longest);
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", json_of(result, out).dump(1));
  else
    print_text(result, out);
}

}  // namespace millwear::orchestrator
