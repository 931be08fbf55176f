#include "orchestrator/dem_run/stretch_measures.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "liggghts_inputs/outputs/torque_series.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "wear/numerics/block_means.h"
#include "wear/rate/load_rate.h"
#include "wear/record/load_accumulator.h"

namespace millwear::orchestrator {
namespace {

/// Mean of a series and its standard error from `blocks` consecutive parts.
wear::Estimate mean_by_blocks(const std::vector<double>& series, int blocks) {
  const double sum = std::accumulate(series.begin(), series.end(), 0.0);
  const auto means = wear::block_means(series, blocks);
  return {sum / static_cast<double>(series.size()),
          means.size() > 0 ? wear::error_of_mean(means.transpose())[0] : std::nan("")};
}

}  // namespace

Measured stretch_measures(const Case& mill, const LinerProfile& dem_liner,
                          const liggghts::StretchSteps& steps, const wear::LinerRecord& record,
                          const std::filesystem::path& torque_file) {
  const auto torque = liggghts::read_torque_series(read_file(torque_file), torque_file.string());
  const long last = torque.empty() ? 0 : torque.back().step;
  const long interval =
      torque.size() < 2 ? steps.measure_steps : last - torque[torque.size() - 2].step;
  if (steps.total() - last >= interval)
    throw ResultRejected(
        fmt::format("{}: ends at step {} of {}", torque_file.string(), last, steps.total()));
  Measured measured{};
  for (const auto& value : torque) {
    measured.power_times.push_back(steps.time_step *
                                   static_cast<double>(value.step - steps.settle_steps));
    measured.power_series.push_back(-value.torque * mill.speed);
  }
  const wear::Estimate power =
      mean_by_blocks(measured.power_series, static_cast<int>(record.load.block_count));
  measured.power = power.value;
  measured.power_error = power.error;
  measured.charge = wear::charge_position(record.angles);
  if (record.motion)
    measured.motion = wear::motion_measures(*record.motion,
                                            {record.load.duration, mill.speed, totals(mill).mass});
  measured.samples = steps.samples();
  measured.rejected_share = wear::rejected_share(record.load);
  measured.revolutions = steps.measure_time() * mill.speed / (2.0 * std::numbers::pi);
  measured.peak_error = record.goal ? record.goal->peak_error
                                    : wear::peak_error_of_load(mill.wear, mill.charge.classes,
                                                               dem_liner, record.load);
  if (record.goal) measured.target_error = record.goal->target_error;
  return measured;
}

}  // namespace millwear::orchestrator
