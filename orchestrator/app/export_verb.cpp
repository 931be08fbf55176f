#include "orchestrator/app/export_verb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "meshgen/profile_cad.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "mill/case_file/case_file.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/export/paraview_folder.h"
#include "orchestrator/export/published_campaign.h"
#include "orchestrator/pictures/charge_pictures.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A file of one liner that was asked for, and how it is written.
struct LinerFile {
  const char* option;
  fs::path file;
  std::function<void(const Case&, const LinerProfile&, const fs::path&)> write;
};

std::vector<LinerFile> liner_files(const ExportOptions& options) {
  std::vector<LinerFile> files;
  if (options.stl) files.push_back({"--stl", *options.stl, write_mesh_stl});
  if (options.step)
    files.push_back(
        {"--step", *options.step, [](const Case& mill, const auto& liner, const auto& to) {
           meshgen::write_step(liner, mill.slice_length, to);
         }});
  if (options.dxf)
    files.push_back({"--dxf", *options.dxf, [](const Case&, const auto& liner, const auto& to) {
                       meshgen::write_dxf(liner, to);
                     }});
  if (options.csv)
    files.push_back({"--csv", *options.csv, [](const Case&, const auto& liner, const auto& to) {
                       publish(to, profile_csv(liner));
                     }});
  return files;
}

/// Throws Failure (usage) where something that was asked for goes with nothing else.
void check_choice(const ExportOptions& options, bool has_liner_files) {
  if (!options.paraview && !options.images && !has_liner_files)
    throw Failure(ExitCode::usage,
                  "export what? Name a folder with --paraview or --images, or a file with --stl, "
                  "--step, --dxf or --csv");
  if ((options.cycle && !options.images && !has_liner_files) ||
      (options.at_step && !has_liner_files))
    throw Failure(ExitCode::usage,
                  "--cycle and --at-step choose the liner of --stl, --step, --dxf and --csv, and "
                  "--cycle the pictures of --images; --paraview has all steps. Add one of these, "
                  "or leave the choice out");
  if (options.extent == LinerExtent::one_lifter && !options.paraview)
    throw Failure(ExitCode::usage, "--one-lifter is for --paraview; add that, or leave it out");
}

void check_places(const ExportOptions& options, const std::vector<LinerFile>& files) {
  if (options.paraview) check_output_folder("--paraview", *options.paraview);
  if (options.images) check_output_folder("--images", *options.images);
  for (const auto& [option, file, write] : files)
    check_output_file(option, file, {options.common.case_file});
}

/// "cycles 0 to 11", "cycles 2, 5"
std::string spoken_cycles(const std::vector<int>& cycles) {
  const bool in_a_row = cycles.back() - cycles.front() == static_cast<int>(cycles.size()) - 1;
  if (cycles.size() == 1) return fmt::format("cycle {}", cycles.front());
  return in_a_row ? fmt::format("cycles {} to {}", cycles.front(), cycles.back())
                  : fmt::format("cycles {}", fmt::join(cycles, ", "));
}

/// What is missing of a campaign, and how to get it, a line each.
std::vector<std::string> spoken_missing(const ParaviewExport& written, const RunFolder& folder) {
  std::vector<std::string> lines;
  if (!written.cycles_without_load.empty())
    lines.push_back(
        fmt::format("no loads on the liner of {}: {} has no dem/load.h5 of them. Export from the "
                    "folder that the "
                    "campaign ran in",
                    spoken_cycles(written.cycles_without_load), folder.root.string()));
  if (!written.cycles_without_charge.empty())
    lines.push_back(fmt::format(
        "no charge of {}: {} has no dem/charge.h5 with frames of them. Earlier versions did not "
        "record it; `millwear run` into another folder (--out) measures the cycles again",
        spoken_cycles(written.cycles_without_charge), folder.root.string()));
  return lines;
}

Json json_of(const ParaviewExport& written, const fs::path& into,
             const std::vector<std::string>& missing) {
  Json series = Json::array();
  for (const auto& [file, times] : written.series)
    series.push_back({{"file", file}, {"times", times}});
  return {{"folder", into.string()}, {"series", series}, {"missing", missing}};
}

Json json_of(const ProfileRow& row, const std::vector<LinerFile>& files) {
  Json names = Json::array();
  for (const auto& file : files) names.push_back(file.file.string());
  return {{"cycle", row.cycle},
          {"step", row.step},
          {"operating_hours", row.operating_hours},
          {"files", names}};
}

/// Of a cycle, or of the last that recorded its charge; returns which.
int write_pictures(const PublishedCampaign& published, std::optional<int> cycle,
                   const fs::path& folder) {
  for (int chosen = cycle.value_or(cycles_begun(published) - 1); chosen >= cycle.value_or(0);
       --chosen)
    if (frames_of(published, chosen)) {
      write_pictures_of_cycle(published.campaign, *published.ledger, chosen, folder);
      return chosen;
    }
  throw Failure(
      ExitCode::usage,
      fmt::format("{} has no dem/charge.h5 with frames of {}: the cycle is not measured yet, or "
                  "by an earlier version; `millwear run` into another folder (--out) measures "
                  "it again",
                  published.campaign.folder.root.string(),
                  cycle ? fmt::format("cycle {}", *cycle) : "any cycle"));
}

}  // namespace

void add_options(CLI::App& verb, ExportOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  verb.add_option("--paraview", options.paraview,
                  "Write liner and charge as .pvd series for ParaView into this folder");
  verb.add_flag_callback(
      "--one-lifter", [&] { options.extent = LinerExtent::one_lifter; },
      "With --paraview: one lifter with its plate in place of the whole ring");
  verb.add_option("--images", options.images,
                  "Write the pictures of one cycle's charge, and the section in each of its frames "
                  "for a film, as PNG into this folder");
  verb.add_option("--stl", options.stl, "Write the liner of one step as the DEM's mesh [m]");
  verb.add_option("--step", options.step, "Write one lifter with its plate as a solid [mm]");
  verb.add_option("--dxf", options.dxf, "Write its profile as a polyline [mm]");
  add_csv(verb, options.csv, "Write its profile as nodes xi_m,eta_m [m]");
  verb.add_option("--cycle", options.cycle,
                  "Cycle of the liner in these files, and of the pictures; by default the last");
  verb.add_option(
      "--at-step", options.at_step,
      "Geometry step of that cycle; by default its last, 0 in cycle 0 is the new liner");
}

void export_verb(const ExportOptions& options) {
  const auto files = liner_files(options);
  check_choice(options, !files.empty());
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const RunFolder folder = run_folder_of(mill, options.out);
  check_places(options, files);
  const PublishedCampaign published = published_campaign(mill, folder);
  Progress progress(options.common.verbosity);
  Json json;
  if (!files.empty()) {
    const ProfileRow& row = profile_after(published, options.cycle, options.at_step);
    for (const auto& file : files)
      file.write(published.campaign.mill, {mill.liner.sector, row.nodes}, file.file);
    json["liner"] = json_of(row, files);
    if (options.common.form == OutputForm::text)
      fmt::print("cycle {}, step {}, {:.0f} h: {}\n", row.cycle, row.step, row.operating_hours,
                 fmt::join(json["liner"]["files"].get<std::vector<std::string>>(), ", "));
  }
  if (options.images) {
    const int cycle = write_pictures(published, options.cycle, *options.images);
    json["images"] = {{"cycle", cycle}, {"folder", options.images->string()}};
    if (options.common.form == OutputForm::text)
      fmt::print("cycle {}: {}\n", cycle, options.images->string());
  }
  if (options.paraview) {
    const auto written = export_to_paraview(published, options.extent, *options.paraview);
    const auto missing = spoken_missing(written, folder);
    for (const auto& line : missing) progress.say(line);
    json["paraview"] = json_of(written, *options.paraview, missing);
    if (options.common.form == OutputForm::text)
      for (const auto& [file, times] : written.series)
        fmt::print("{}: {} times\n", (*options.paraview / file).string(), times);
  }
  if (options.common.form == OutputForm::json) fmt::print("{}\n", json.dump(1));
}

}  // namespace millwear::orchestrator
