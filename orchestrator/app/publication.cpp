#include "orchestrator/app/publication.h"

#include <fmt/format.h>

#include <cmath>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/calibration/course_calibration.h"
#include "orchestrator/gauge/gauge_folder.h"
#include "orchestrator/pictures/charge_pictures.h"
#include "orchestrator/pictures/plots.h"
#include "orchestrator/report/report.h"
#include "orchestrator/results/gather.h"
#include "orchestrator/results/result_files.h"

namespace millwear::orchestrator {
namespace {

void add_readings_of(const Case& mill, const std::optional<std::filesystem::path>& named,
                     CampaignResults& data) {
  try {
    const auto readings = readings_in(gauge_folder(mill, named), mill);
    add_readings(readings, data);
    add_calibrated_course(mill, readings, data);
  } catch (const InputError& problem) {
    if (named) throw;
    data.warnings.push_back(fmt::format("the gauge readings are left out: {}", problem.what()));
  }
}

}  // namespace

CampaignResults publish_campaign(const OpenCampaign& opened,
                                 const std::optional<std::filesystem::path>& readings) {
  const auto& [campaign, ledger] = opened;
  CampaignResults data = gather(campaign, ledger);
  add_readings_of(campaign.mill, readings, data);
  add_kept_pictures(campaign, ledger, data.charge);
  publish_results(campaign, ledger, data);
  publish(campaign.folder.report(), report_html(data));
  return data;
}

void publish_pictures(const OpenCampaign& opened, const std::set<int>& chosen,
                      CampaignResults& data) {
  const auto& [campaign, ledger] = opened;
  write_plots(data, campaign.folder.results());
  std::set<int> cycles = first_and_last(data.charge);
  cycles.insert(chosen.begin(), chosen.end());
  if (draw_charge_pictures(campaign, ledger, cycles, data.charge))
    publish(campaign.folder.report(), report_html(data));
}

void publish_pictures_if_possible(const OpenCampaign& opened, CampaignResults& data,
                                  Progress& progress) {
  try {
    publish_pictures(opened, {}, data);
  } catch (const ExternalProgramError& problem) {
    progress.say(std::string("pictures are missing in results/: ") + problem.what());
  }
}

std::string spoken_outcome(const CampaignResults& data) {
  if (data.history.empty()) return "no cycle is finished yet";
  const auto& last = data.history.back();
  const std::string band = std::isfinite(data.life.hours_low)
                               ? fmt::format(" (95 % band {:.0f} to {:.0f} h)", data.life.hours_low,
                                             data.life.hours_high)
                               : "";
  return fmt::format(
      "{} {:.0f} h{}: lifter {:.1f} mm high, plate {:.1f} mm thick, roughness {:.2f} mm, {} cycles",
      data.life.reached ? "worn out at" : "worn for", last.operating_hours, band,
      1e3 * last.lifter_height, 1e3 * last.plate_thickness, 1e3 * last.roughness,
      data.conservation.size());
}

void print_outcome(OutputForm form, const RunFolder& folder, const CampaignResults& data) {
  if (form == OutputForm::json)
    fmt::print("{}\n", read_file(folder.results() / "summary.json"));
  else
    fmt::print("{}\nreport: {}\n", spoken_outcome(data), folder.report().string());
}

}  // namespace millwear::orchestrator
