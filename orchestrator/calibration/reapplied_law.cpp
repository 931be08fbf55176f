#include "orchestrator/calibration/reapplied_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/constants.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/campaign/campaign.h"
#include "orchestrator/campaign/case_difference.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/stage_order.h"
#include "orchestrator/dem_run/measured.h"
#include "wear/numerics/block_means.h"
#include "wear/numerics/block_persistence.h"
#include "wear/rate/load_rate.h"
#include "wear/rate/wear_law.h"
#include "wear/record/load_accumulator.h"
#include "wear/record/load_read.h"

namespace millwear::orchestrator {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// Distributions this near differ by the rounding of one factor.
constexpr double same_within = 1e-12;

WallLoad bins_of(const Case& mill, const WallLoad& recorded) {
  return wear::coarsened(recorded, static_cast<int>(recorded.bins()) / mill.wear.bins);
}

LawOnCycle law_on_cycle(const Campaign& campaign, const Case& other, const Ledger& ledger,
                        int cycle) {
  const auto recorded =
      wear::read_load(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load);
  LawOnCycle result{
      cycle, lifter_height(liner_of_cycle(campaign, cycle)),
      law_on_load(campaign.mill, other, dem_liner_of_cycle(campaign, cycle), recorded), unknown,
      unknown};
  const StageId worn{cycle, StageKind::wear};
  if (ledger.find(worn) == nullptr) return result;
  const auto kept =
      read_cycle(campaign.folder.stage(worn) / stage_files::steps, campaign.mill.liner.sector);
  result.campaign_hours = 0.0;
  for (const auto& step : kept.steps) result.campaign_hours += step.duration / seconds_per_hour;
  result.hours = result.campaign_hours * result.law.campaign_rate / result.law.section_rate;
  return result;
}

}  // namespace

double share_elsewhere(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                       const Eigen::VectorXd& widths) {
  const double of_first = first.dot(widths);
  const double of_second = second.dot(widths);
  if (!(of_first > 0.0 && of_second > 0.0)) return unknown;
  return 0.5 * (first / of_first - second / of_second).cwiseAbs().dot(widths);
}

LawOnLoad law_on_load(const Case& campaign, const Case& other, const LinerProfile& dem_liner,
                      const WallLoad& recorded) {
  const auto before =
      wear::rate_of_load(campaign.wear, campaign.charge.classes, dem_liner, recorded);
  const auto after = wear::rate_of_load(other.wear, other.charge.classes, dem_liner, recorded);
  const Eigen::VectorXd widths = before.load.bin_widths();
  LawOnLoad result{after.raw.dot(widths),
                   before.raw.dot(widths),
                   {},
                   share_elsewhere(after.raw, before.raw, widths)};
  if (!(result.elsewhere <= same_within))
    result.elsewhere =
        share_elsewhere(after.smoothed.rate.values, before.smoothed.rate.values, widths);
  else
    result.elsewhere = 0.0;
  for (const auto& mechanism : other.wear.mechanisms) {
    const auto weights = wear::weights_of(mechanism, other.charge.classes);
    const double section = wear::depth_rate(weights, after.load).dot(widths);
    result.shares.push_back(result.section_rate > 0.0 ? section / result.section_rate : unknown);
  }
  return result;
}

ReappliedLaw reapply(const Case& mill, const RunFolder& folder) {
  const auto [campaign, ledger] = campaign_with_loads(folder);
  const Case& run = campaign.mill;
  ReappliedLaw result{run,
                      with_law_of(as_kept(mill, folder), run, folder.root.string()),
                      {},
                      outcome_of(ledger) != Outcome::go_on,
                      lifter_height(run.liner),
                      0.0,
                      0.0,
                      unknown};
  for (int cycle = 0; ledger.find({cycle, StageKind::dem}) != nullptr; ++cycle) {
    result.cycles.push_back(law_on_cycle(campaign, result.other, ledger, cycle));
    const LawOnCycle& last = result.cycles.back();
    if (!(last.campaign_hours > 0.0)) continue;
    result.campaign_hours += last.campaign_hours;
    result.hours += last.hours;
    result.elsewhere = std::fmax(result.elsewhere, last.law.elsewhere);
    result.lifter_height = lifter_height(liner_of_cycle(campaign, cycle + 1));
  }
  return result;
}

std::vector<WearRateRow> wear_rates(const ReappliedLaw& law, const RunFolder& folder) {
  std::vector<WearRateRow> rows;
  for (const auto& cycle : law.cycles) {
    const auto load =
        bins_of(law.other,
                wear::read_load(folder.stage({cycle.cycle, StageKind::dem}) / stage_files::load));
    const Eigen::VectorXd centres =
        0.5 * (load.bin_edges.head(load.bins()) + load.bin_edges.tail(load.bins()));
    int number = 0;
    for (const auto& mechanism : law.other.wear.mechanisms) {
      const auto weights = wear::weights_of(mechanism, law.other.charge.classes);
      const Eigen::VectorXd rate = wear::depth_rate(weights, load);
      const Eigen::VectorXd error =
          wear::error_of_mean(wear::as_independent(wear::depth_rate_by_block(weights, load)));
      for (Eigen::Index bin = 0; bin < load.bins(); ++bin)
        rows.push_back({cycle.cycle, number, std::string(name_of(mechanism.law)),
                        static_cast<int>(bin), centres[bin], rate[bin], error[bin]});
      ++number;
    }
  }
  return rows;
}

}  // namespace millwear::orchestrator
