#include "mill/case_file/case_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mill/case/operated_mill.h"
#include "mill/case_file/case_checks.h"
#include "mill/liner/liner_profile.h"

namespace millwear {
namespace {

/// Relative difference of computed and declared filling that is not worth a word.
constexpr double filling_tolerance = 0.1;

/// Fewer time blocks leave standard errors of the load so uncertain that its bands get wide.
constexpr int advised_time_blocks = 5;

/// The first mechanism that counts collisions one by one, or nullptr.
const WearMechanism* law_of_impacts(const Case& mill) {
  const auto& all = mill.wear.mechanisms;
  const auto found = std::find_if(all.begin(), all.end(), [](const WearMechanism& mechanism) {
    return mechanism.law == WearLaw::incident_energy || mechanism.law == WearLaw::excess_energy;
  });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::vector<std::string> warnings(const Case& mill) {
  std::vector<std::string> texts;
  const double largest = largest_diameter(mill);
  const double smallest = smallest_diameter(mill);
  if (const double fraction = critical_speed_fraction(mill); fraction > 1.0) {
    texts.push_back(fmt::format(
        "the mill turns above its critical speed ({:.3g} of it: particles of {:.3g} m centrifuge); "
        "lower the speed below 1",
        fraction, largest));
  }
  for (std::size_t i = 0; i < mill.campaign.operation.size(); ++i) {
    const Case operated = as_operated(mill, std::vector{i});
    if (const double fraction = critical_speed_fraction(operated);
        operated.speed != mill.speed && fraction > 1.0)
      texts.push_back(
          fmt::format("change {} of the operation turns the mill above its critical speed ({:.3g} "
                      "of it); lower "
                      "the speed below 1",
                      i + 1, fraction));
  }
  if (mill.slice_length < advised_slice_diameters * largest) {
    texts.push_back(fmt::format(
        "the slice is narrow ({:.3g} m, {:.3g} of its largest particles); {:.3g} m or "
        "more would not hinder their packing",
        mill.slice_length, mill.slice_length / largest, advised_slice_diameters * largest));
  }
  const double filling = filling_inside_plate(mill);
  if (const auto declared = mill.charge.declared.total;
      declared && std::abs(filling - *declared) > filling_tolerance * *declared) {
    texts.push_back(fmt::format(
        "the counts make {:.1f} % filling where {:.1f} % is declared ({} particles, {:.3g} m3 of "
        "solid in {:.3g} m3 at porosity {}); mend the counts, or give the charge by filling",
        100.0 * filling, 100.0 * *declared, totals(mill).particles, totals(mill).solid_volume,
        totals(mill).solid_volume / (1.0 - mill.charge.porosity) / filling, mill.charge.porosity));
  }
  const double bin = arc_lengths(mill.liner).back() / mill.wear.bins;
  if (bin > 0.25 * smallest) {
    texts.push_back(
        fmt::format("the wear bins are wide ({:.3g} mm, half the least particle radius is {:.3g} "
                    "mm); {:.0f} or more would resolve single contacts",
                    bin * 1e3, 0.25 * smallest * 1e3,
                    std::ceil(arc_lengths(mill.liner).back() / (0.25 * smallest))));
  }
  if (const int blocks = mill.wear.time_blocks; blocks < advised_time_blocks) {
    texts.push_back(
        fmt::format("the standard errors of the load come from {} time blocks, and their bands are "
                    "wide for want of more (Student's distribution of {} degree{} of freedom); {} "
                    "or more would do",
                    blocks, blocks - 1, blocks == 2 ? "" : "s", advised_time_blocks));
  }
  if (const WearMechanism* const law = law_of_impacts(mill);
      law != nullptr && mill.dem.sample_every_steps > 1) {
    texts.push_back(fmt::format(
        "the law `{}` counts collisions, and of the short ones some are missed (a sample every {} "
        "steps); take `wall_contacts = \"recorder\"` with every step",
        name_of(law->law), mill.dem.sample_every_steps));
  }
  return texts;
}

}  // namespace millwear
