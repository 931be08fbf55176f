#include "orchestrator/app/wear_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mill/base/constants.h"
#include "mill/base/number_or_null.h"
#include "mill/base/published_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/calibration/reapplied_law.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/drawing/drawn_liner_reader.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

nlohmann::json mechanisms_json(const Case& mill) {
  nlohmann::json mechanisms = nlohmann::json::array();
  for (const auto& mechanism : mill.wear.mechanisms)
    mechanisms.push_back(
        {{"law", name_of(mechanism.law)}, {"spoken", spoken(mechanism, mill.materials)}});
  return mechanisms;
}

nlohmann::json json_of(const ReappliedLaw& law) {
  nlohmann::json cycles = nlohmann::json::array();
  for (const auto& cycle : law.cycles) {
    nlohmann::json shares = nlohmann::json::array();
    for (const double share : cycle.law.shares) shares.push_back(number_or_null(share));
    cycles.push_back(
        {{"cycle", cycle.cycle},
         {"lifter_height_m", cycle.lifter_height},
         {"volume_rate_m3_per_m_h", number_or_null(cycle.law.section_rate * seconds_per_hour)},
         {"relative_rate", number_or_null(cycle.law.section_rate / cycle.law.campaign_rate)},
         {"elsewhere", number_or_null(cycle.law.elsewhere)},
         {"shares", shares},
         {"hours", number_or_null(cycle.hours)},
         {"campaign_hours", number_or_null(cycle.campaign_hours)}});
  }
  return {{"mechanisms", mechanisms_json(law.other)},
          {"campaign_mechanisms", mechanisms_json(law.campaign)},
          {"cycles", cycles},
          {"life_reached", law.life_reached},
          {"lifter_height_m", law.lifter_height},
          {"hours", number_or_null(law.hours)},
          {"campaign_hours", law.campaign_hours},
          {"exact", law.elsewhere == 0.0},
          {"elsewhere", number_or_null(law.elsewhere)}};
}

void print_life(const ReappliedLaw& law) {
  if (!(law.campaign_hours > 0.0)) {
    fmt::print("No cycle's wear is done yet: rates, and no hours.\n");
    return;
  }
  if (!std::isfinite(law.hours)) {
    fmt::print("This law wears nothing in some cycle: it has no life.\n");
    return;
  }
  fmt::print("{} {:.0f} h (lifter {:.1f} mm high), {:.0f} h in the campaign\n",
             law.life_reached ? "Life" : "So far", law.hours, 1e3 * law.lifter_height,
             law.campaign_hours);
  if (law.elsewhere == 0.0)
    fmt::print("Exact: this law is the campaign's times a factor.\n");
  else
    fmt::print(
        "Approximate: up to {:.1f} % of the wear falls elsewhere on the profile than in the\n"
        "campaign, whose liners and loads these are; `millwear run` this law for its own.\n",
        100.0 * law.elsewhere);
}

void print_text(const ReappliedLaw& law) {
  fmt::print("Law       {}\nCampaign  {}\n", spoken(law.other.wear.mechanisms, law.other.materials),
             spoken(law.campaign.wear.mechanisms, law.campaign.materials));
  fmt::print("cycle  lifter        rate  relative  elsewhere      hours  campaign  shares\n");
  fmt::print("           mm    m3/(m h)                              h         h\n");
  for (const auto& cycle : law.cycles) {
    fmt::print("{:5}  {:6.1f}  {:10.3e}  {:8.4g}  {:9.4f}  {:9.1f}  {:8.1f} ", cycle.cycle,
               1e3 * cycle.lifter_height, cycle.law.section_rate * seconds_per_hour,
               cycle.law.section_rate / cycle.law.campaign_rate, cycle.law.elsewhere, cycle.hours,
               cycle.campaign_hours);
    for (const double share : cycle.law.shares) fmt::print(" {:.3f}", share);
    fmt::print("\n");
  }
  print_life(law);
}

}  // namespace

void add_options(CLI::App& verb, WearOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  add_csv(verb, options.csv, "Write the depth rate by cycle, mechanism and bin");
}

void wear_verb(const WearOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const RunFolder folder = run_folder_of(mill, options.out);
  if (options.csv) check_output_file("--csv", *options.csv, {options.common.case_file});
  const ReappliedLaw law = reapply(mill, folder);
  if (options.csv) publish(*options.csv, wear_rates_csv(wear_rates(law, folder)));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", json_of(law).dump(1));
  else
    print_text(law);
}

}  // namespace millwear::orchestrator
