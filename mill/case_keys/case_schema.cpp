#include "mill/case_keys/case_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "mill/case_keys/campaign_keys.h"
#include "mill/case_keys/charge_keys.h"
#include "mill/case_keys/dem_keys.h"
#include "mill/case_keys/mill_keys.h"
#include "mill/case_keys/wear_keys.h"

namespace millwear {
namespace {

constexpr std::array<TableSpec, 14> tables{{
    {"", false, true, "The keys before the first table."},
    {"mill", false, true, "The mill and the slice of it that is simulated."},
    {"lifter", false, true,
     "One lifter and its share of the plate: by `height_m`, `top_width_m` and two face angles, or "
     "measured in `profile_csv`, or listed in `nodes_m`."},
    {"materials", true, true, "A solid: the liner's, a ball's, an ore's."},
    {"pairs", true, true, "How two materials touch; one for each pair that can meet."},
    {"charge", false, true,
     "Balls and ore: by [[charge.counts]], or by `total_filling` and [[charge.distributions]]."},
    {"charge.counts", true, false, "Particles of one material and one size in the slice."},
    {"charge.distributions", true, false,
     "Sieve analysis of one material. Its share of the filling becomes particle counts: bulk "
     "volume = filling x pi R^2 L with R the plate's radius, solid = bulk x (1 - porosity)."},
    {"dem", false, false, "The discrete element model."},
    {"wear", false, true,
     "From wall contacts to lost steel: one law for all particles here, or a sum of laws in "
     "[[wear.mechanisms]]."},
    {"wear.mechanisms", true, false,
     "One law of the sum. Where two of the same law concern the same particles, their "
     "coefficients add."},
    {"campaign", false, true, "When the DEM is run anew, and when the liner is worn out."},
    {"campaign.operation", true, false,
     "A change of how the mill is operated, at given hours or at a lifter height. What a change "
     "does "
     "not give stays as it was before."},
    {"gauge", false, false,
     "How the gauge readings beside this file are held against the campaign. It may be changed at "
     "any time: what is simulated does not depend on it, and `case.lock.toml` has none of it."},
}};

template <typename Settings>
void append(std::vector<KeySpec>& specs, const std::vector<KeyRow<Settings>>& rows) {
  for (const KeyRow<Settings>& row : rows) specs.push_back(row.spec);
}

std::vector<KeySpec> all_keys() {
  std::vector<KeySpec> specs;
  append(specs, top_keys());
  append(specs, mill_keys());
  append(specs, lifter_keys());
  append(specs, lifter_shape_keys());
  append(specs, lifter_radius_keys());
  append(specs, lifter_profile_keys());
  append(specs, material_keys());
  append(specs, pair_keys());
  append(specs, charge_keys());
  append(specs, count_keys());
  append(specs, distribution_keys());
  append(specs, dem_keys());
  append(specs, one_law_keys());
  append(specs, wear_keys());
  append(specs, mechanism_keys());
  append(specs, campaign_keys());
  append(specs, operation_keys());
  append(specs, gauge_keys());
  return specs;
}

}  // namespace

std::span<const TableSpec> case_tables() { return tables; }

std::span<const KeySpec> case_keys() {
  static const std::vector<KeySpec> keys = all_keys();
  return keys;
}

const KeySpec* find_key(std::string_view table, std::string_view key) {
  const auto keys = case_keys();
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeySpec& spec) {
    return spec.table == table && spec.key == key;
  });
  return found == keys.end() ? nullptr : &*found;
}

const TableSpec* find_table_spec(std::string_view table) {
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [&](const TableSpec& spec) { return spec.name == table; });
  return found == tables.end() ? nullptr : &*found;
}

std::string table_heading(const TableSpec& table) {
  if (table.name.empty()) {
    return "the top of the file";
  }
  return table.repeats ? fmt::format("[[{}]]", table.name) : fmt::format("[{}]", table.name);
}

}  // namespace millwear
