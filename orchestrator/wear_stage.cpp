#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "orchestrator/load_rate.h"
#include "orchestrator/stages.h"
#include "wear/evolution.h"
#include "wear/load_accumulator.h"
#include "wear/load_store.h"
#include "wear/wear_law.h"

namespace millwear::orchestrator {
namespace {

Outcome outcome_from_end(wear::EvolutionEnd end) {
  switch (end) {
    case wear::EvolutionEnd::threshold_reached:
      return Outcome::go_on;
    case wear::EvolutionEnd::height_limit:
      return Outcome::height_limit;
    case wear::EvolutionEnd::plate_limit:
      return Outcome::plate_limit;
  }
  throw std::logic_error("an end of no kind");
}

}  // namespace

double smoothing_resolution(const Case& mill) { return 0.5 * smallest_diameter(mill); }

LoadRate rate_of_load(const Case& mill, const WallLoad& recorded) {
  const auto load = wear::coarsened(recorded, static_cast<int>(recorded.bins()) / mill.wear.bins);
  auto by_contact = wear::weights_of(mill);
  const double corrosion = std::exchange(by_contact.corrosion, 0.0);
  const Eigen::VectorXd raw = wear::depth_rate(by_contact, load);
  auto smoothed = wear::smoothed(load.bin_edges, raw, wear::depth_rate_by_block(by_contact, load),
                                 smoothing_resolution(mill));
  if (corrosion > 0.0) {
    smoothed.rate.values.array() += corrosion;
    smoothed.moved_share *= raw.sum() / smoothed.rate.values.sum();
  }
  return {load, raw.array() + corrosion, std::move(smoothed)};
}

Eigen::VectorXd error_of_mean(const Eigen::MatrixXd& by_block) {
  const auto blocks = static_cast<double>(by_block.cols());
  if (by_block.cols() < 2) return Eigen::VectorXd::Constant(by_block.rows(), std::nan(""));
  const Eigen::VectorXd mean = by_block.rowwise().mean();
  return ((by_block.colwise() - mean).rowwise().squaredNorm() / (blocks * (blocks - 1.0)))
      .cwiseSqrt();
}

Outcome wear_stage(const Campaign& campaign, int cycle, const std::filesystem::path& into) {
  const auto& mill = campaign.mill;
  const auto recorded =
      wear::read_load(campaign.folder.stage({cycle, StageKind::dem}) / stage_files::load);
  const LoadRate rate = rate_of_load(mill, recorded);
  const auto evolution = wear::evolve(liner_of_cycle(campaign, cycle), rate.smoothed.rate,
                                      lifter_area(mill.liner), mill.campaign);
  KeptCycle kept{rate.smoothed.moved_share, rate.raw.dot(rate.load.bin_widths()), {}};
  for (const auto& step : evolution.steps)
    kept.steps.push_back(
        {step.duration, step.removed_area, step.accounted_area, step.fallen_area, step.profile});
  write_cycle(into / stage_files::steps, kept);
  return outcome_from_end(evolution.end);
}

}  // namespace millwear::orchestrator
