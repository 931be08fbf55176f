#include "orchestrator/export/liner_values.h"

#include <utility>

#include "mill/base/constants.h"
#include "orchestrator/export/liner_surface.h"
#include "wear/evolve/load_carrier.h"

namespace millwear::orchestrator {
namespace {

constexpr double mm_per_1000_h = 1000.0 * seconds_per_hour * millimetres_per_metre;  // of 1 m/s

/// An array of a value a segment, given one a bin.
VtkArray by_segment(const char* name, const Eigen::VectorXd& by_bin,
                    const std::vector<Eigen::Index>& bins) {
  std::vector<float> values;
  for (const auto bin : bins) values.push_back(static_cast<float>(by_bin[bin]));
  return {name, 1, std::move(values)};
}

}  // namespace

VtkArray wear_depth(const LinerProfile& outline, const wear::ProfileIndex& fresh) {
  std::vector<float> depths;
  for (std::size_t i = 1; i < outline.nodes.size(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (outline.nodes[i - 1] + outline.nodes[i]);
    depths.push_back(static_cast<float>(fresh.nearest(middle).distance));
  }
  return {"wear_depth_m", 1, std::move(depths)};
}

std::vector<VtkArray> load_values(const LoadOnLiner& measured, const LinerProfile& worn) {
  const auto& [liner, rotation, load] = measured;
  const auto bins = static_cast<Eigen::Index>(load.arc_length.size());
  const wear::LoadCarrier carrier(as_turned(liner, rotation), bins);
  const auto carried = carrier.onto_bins(as_turned(worn, rotation), bins);
  const auto segments = bins_of_segments(cut_at_bins(worn, bins), bins);
  const auto array = [&](const char* name, const std::vector<double>& values, double per_unit) {
    const Eigen::VectorXd in_the_dem =
        carried * Eigen::Map<const Eigen::VectorXd>(values.data(), bins) * per_unit;
    return by_segment(name, by_bin_as_turned(in_the_dem, rotation), segments);
  };
  return {array("wear_rate_mm_per_1000_h", load.depth_rate.smoothed, mm_per_1000_h),
          array("sliding_work_w_per_m2", load.sliding_work.raw, 1.0),
          array("normal_dissipation_w_per_m2", load.normal_dissipation.raw, 1.0),
          array("contacts_per_m", load.contacts.raw, 1.0)};
}

}  // namespace millwear::orchestrator
