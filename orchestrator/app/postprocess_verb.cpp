#include "orchestrator/app/postprocess_verb.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "mill/base/number_or_null.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_csv.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/app/verbs.h"
#include "orchestrator/postprocess/postprocess_dumps.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr double seconds_per_hour = 3600.0;
constexpr double degree = std::numbers::pi / 180.0;

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

std::string_view name_of(wear::EvolutionEnd end) {
  switch (end) {
    case wear::EvolutionEnd::load_spent:
      return "load_spent";
    case wear::EvolutionEnd::time_reached:
      return "time_reached";
    case wear::EvolutionEnd::height_limit:
      return "height_limit";
    case wear::EvolutionEnd::plate_limit:
      return "plate_limit";
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
          {"end", name_of(result.end)},
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

void postprocess(const PostprocessOptions& options) {
  const Case mill = read_case(options.case_file);
  const LinerProfile liner =
      options.profile ? read_profile_csv(*options.profile, mill.liner.sector) : mill.liner;
  HandRun run = options.run;
  run.angle = options.angle_deg * degree;
  const fs::path out = options.out.empty() ? fs::path("postprocess") / mill.name : options.out;
  const double longest =
      options.hours ? *options.hours * seconds_per_hour : std::numeric_limits<double>::infinity();
  const PostprocessedDumps result = postprocess_dumps(mill, liner, run, out, longest);
  if (options.json)
    fmt::print("{}\n", json_of(result, out).dump(1));
  else
    print_text(result, out);
}

void postprocess_verb(const Command& command) {
  PostprocessOptions options = command.postprocess;
  options.case_file = command.case_file;
  options.out = command.out;
  options.profile = command.profile;
  options.json = command.form == OutputForm::json;
  postprocess(options);
}

}  // namespace millwear::orchestrator
