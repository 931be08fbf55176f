#include "mill/case_file/case_lock.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iterator>
#include <optional>

#include "mill/case/case_units.h"
#include "mill/case_keys/case_schema.h"

namespace millwear {
namespace {

/// Appends `key = value` lines; numbers in the shortest form that reads back the same.
class LockWriter {
 public:
  void table(std::string_view heading) { put("\n{}\n", heading); }
  template <typename Value>
  void key(std::string_view name, const Value& value) {
    put("{} = {}\n", name, value);
  }
  void text(std::string_view name, std::string_view value) { put("{} = \"{}\"\n", name, value); }
  void key_if(std::string_view name, const std::optional<double>& value) {
    if (value) {
      key(name, *value);
    }
  }
  template <typename... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }
  [[nodiscard]] std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

void write_mill(const Case& mill, LockWriter& lock) {
  lock.table("[mill]");
  lock.key("shell_diameter_m", 2.0 * mill.liner.sector.shell_radius);
  lock.key("slice_length_m", mill.slice_length);
  lock.key("rows", mill.liner.sector.rows);
  lock.key("speed_rpm", mill.speed / speed_from_rpm(1.0));
  if (mill.feed_rate) {
    lock.key("feed_rate_t_per_h", *mill.feed_rate / feed_from_t_per_h(1.0));
  }
}

void write_lifter(const Case& mill, LockWriter& lock) {
  lock.table("[lifter]");
  lock.text("material", mill.materials.at(mill.liner_material).name);
  lock.key("plate_thickness_m", mill.liner.sector.shell_radius - mill.liner.sector.plate_radius);
  lock.put("nodes_m = [\n");
  for (const Eigen::Vector2d& node : mill.liner.nodes) {
    lock.put("  [{}, {}],\n", node.x(), node.y());
  }
  lock.put("]\n");
}

void write_materials(const Case& mill, LockWriter& lock) {
  for (const Material& material : mill.materials) {
    lock.table("[[materials]]");
    lock.text("name", material.name);
    lock.key("density_kg_per_m3", material.density);
    lock.key("shear_modulus_pa", material.shear_modulus);
    lock.key("poisson_ratio", material.poisson_ratio);
    lock.key_if("modulus_reduction", material.modulus_reduction);
  }
  for (const MaterialPair& pair : mill.pairs) {
    lock.table("[[pairs]]");
    lock.put("materials = [\"{}\", \"{}\"]\n", mill.materials.at(pair.first).name,
             mill.materials.at(pair.second).name);
    lock.key("sliding_friction", pair.sliding_friction);
    lock.key("rolling_friction", pair.rolling_friction);
    lock.key("restitution", pair.restitution);
  }
}

void write_charge(const Case& mill, LockWriter& lock) {
  lock.table("[charge]");
  lock.key("porosity", mill.charge.porosity);
  lock.key("truncate_below_m", mill.charge.truncate_below);
  lock.key_if("declared_total_filling", mill.charge.declared.total);
  lock.key_if("declared_ball_filling", mill.charge.declared.balls);
  for (const ParticleClass& c : mill.charge.classes) {
    lock.table("[[charge.counts]]");
    lock.text("material", mill.materials.at(c.material).name);
    lock.key("diameter_m", c.diameter);
    lock.key("count", c.count);
  }
}

void write_dem(const DemSettings& dem, LockWriter& lock) {
  lock.table("[dem]");
  lock.key("modulus_reduction", dem.modulus_reduction);
  lock.key("rayleigh_fraction", dem.rayleigh_fraction);
  lock.key_if("longest_time_step_s", dem.longest_time_step);
  lock.key_if("time_step_s", dem.time_step);
  lock.text("rolling_friction_model",
            dem.rolling_friction == RollingFriction::cdt ? "cdt" : "epsd2");
  lock.key("mix_revolutions", dem.mix_revolutions);
  if (dem.mix_until_steady) lock.key("mix_until_steady", true);
  lock.key("settle_pitches", dem.settle_pitches);
  lock.key("measure_revolutions", dem.measure_revolutions);
  if (dem.error_target) {
    lock.key("target_relative_error", dem.error_target->relative_error);
    lock.key("most_revolutions", dem.error_target->most_revolutions);
  }
  lock.text("wall_contacts", name_of(dem.contact_path));
  lock.key("sample_every_steps", dem.sample_every_steps);
  lock.key("ranks", dem.ranks);
  lock.key_if("skin_m", dem.skin);
  if (dem.rank_split) lock.text("rank_split", name_of(*dem.rank_split));
  if (dem.tune) lock.key("tune", true);
  lock.key("mesh_tolerance", dem.mesh_tolerance);
  lock.key("seed", dem.seed);
  lock.key("keep_dumps", dem.keep_dumps);
  lock.key("keep_events", dem.keep_events);
  lock.key("pair_revolutions", dem.pair_revolutions);
}

void write_law(const WearMechanism& mechanism, LockWriter& lock) {
  lock.text("law", name_of(mechanism.law));
  if (mechanism.law == WearLaw::corrosion) {
    lock.key("depth_rate_m_per_year", mechanism.depth_rate / depth_rate_from_m_per_year(1.0));
  } else {
    lock.key("specific_wear_rate_per_pa", mechanism.specific_wear_rate);
  }
}

/// One law for all particles stands in [wear] itself, however the case wrote it.
bool is_one_for_all(const std::vector<WearMechanism>& mechanisms) {
  return mechanisms.size() == 1 && !mechanisms.front().material &&
         !mechanisms.front().least_diameter && !mechanisms.front().most_diameter;
}

void write_wear(const Case& mill, LockWriter& lock) {
  const WearSettings& wear = mill.wear;
  lock.table("[wear]");
  const bool short_form = is_one_for_all(wear.mechanisms);
  if (short_form) {
    write_law(wear.mechanisms.front(), lock);
  }
  lock.key("bins", wear.bins);
  lock.key("time_blocks", wear.time_blocks);
  lock.text("smoothing", name_of(wear.smoothing));
  lock.key("excess_speed_m_per_s", wear.excess_speed);
  if (short_form) {
    return;
  }
  for (const WearMechanism& mechanism : wear.mechanisms) {
    lock.table("[[wear.mechanisms]]");
    write_law(mechanism, lock);
    if (mechanism.material) {
      lock.text("material", mill.materials.at(*mechanism.material).name);
    }
    lock.key_if("smallest_diameter_m", mechanism.least_diameter);
    lock.key_if("largest_diameter_m", mechanism.most_diameter);
  }
}

void write_campaign(const CampaignSettings& campaign, LockWriter& lock) {
  lock.table("[campaign]");
  lock.text("scheme", name_of(campaign.scheme));
  lock.key("threshold", campaign.threshold);
  lock.key("step_tolerance", campaign.step_tolerance);
  lock.key("largest_share", campaign.largest_share);
  lock.key("steps_per_cycle", campaign.steps_per_cycle);
  lock.key("height_limit_m", campaign.height_limit);
  lock.key("plate_limit_m", campaign.plate_limit);
  lock.key("cycle_limit", campaign.cycle_limit);
  if (!campaign.reversal_times.empty()) {
    std::vector<double> hours;
    for (const double time : campaign.reversal_times) hours.push_back(time / time_from_hours(1.0));
    lock.put("reversal_hours = [{}]\n", fmt::join(hours, ", "));
  }
}

}  // namespace

std::string locked_case_text(const Case& mill) {
  LockWriter lock;
  lock.put("# The case as it is simulated, every default filled in. Written by millwear.\n");
  lock.key("format_version", case_format_version);
  lock.text("name", mill.name);
  write_mill(mill, lock);
  write_lifter(mill, lock);
  write_materials(mill, lock);
  write_charge(mill, lock);
  write_dem(mill.dem, lock);
  write_wear(mill, lock);
  write_campaign(mill.campaign, lock);
  return std::move(lock).take();
}

}  // namespace millwear
