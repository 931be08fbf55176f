#include "orchestrator/comparison/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "mill/base/constants.h"
#include "mill/base/number_or_null.h"
#include "orchestrator/comparison/shown_cycles.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;
using Figures = ComparedFigures;

/// A figure: its name in JSON, its words, and what turns it into the unit of the words.
struct Column {
  std::string_view name;
  std::string_view text;
  double Figures::*value;
  double Figures::*error;  ///< its standard error; nullptr where it has none
  double per_unit;
  int digits;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

constexpr std::array columns{
    Column{"tonnes", "milled [t]", &Figures::tonnes, nullptr, 1.0, 0},
    Column{"cycles", "DEM cycles", &Figures::cycles, nullptr, 1.0, 0},
    Column{"new_height_m", "new lifter [mm]", &Figures::new_height, nullptr, 1e3, 1},
    Column{"height_m", "lifter at the end [mm]", &Figures::height, nullptr, 1e3, 1},
    Column{"plate_thickness_m", "thinnest plate at the end [mm]", &Figures::plate_thickness,
           nullptr, 1e3, 1},
    Column{"worn_steel_kg_per_m", "steel worn [kg/m]", &Figures::worn_steel,
           &Figures::worn_steel_error, 1.0, 1},
    Column{"power_w_per_m", "power, first load [kW/m]", &Figures::power, &Figures::power_error,
           1e-3, 3},
    Column{"bare_hit_power_w_per_m", "hits on the bare liner [W/m]", &Figures::bare_hit_power,
           &Figures::bare_hit_power_error, 1.0, 2},
    Column{"shoulder_deg", "shoulder from 3 o'clock [deg]", &Figures::shoulder,
           &Figures::shoulder_error, 1.0, 1},
    Column{"toe_deg", "toe from 3 o'clock [deg]", &Figures::toe, &Figures::toe_error, 1.0, 1},
};

Figures without_cycles(const Life& life) {
  Figures figures{};
  figures.life_hours_low = figures.life_hours_high = nan;
  figures.limit = life.limit;
  for (const auto& column : columns) {
    figures.*column.value = nan;
    if (column.error != nullptr) figures.*column.error = nan;
  }
  figures.cycles = 0.0;
  return figures;
}

Figures figures_of(const ComparedCampaign& compared) {
  const auto& [history, life] = std::tie(compared.data.history, compared.data.life);
  if (history.empty()) return without_cycles(life);
  const HistoryRow& fresh = history.front();
  const HistoryRow& last = history.back();
  const double slice = compared.campaign.mill.slice_length;
  const double steel = compared.data.sector.rows * compared.data.liner_density;
  return {.worn_out = life.reached,
          .life_hours = life.hours,
          .life_hours_low = life.hours_low,
          .life_hours_high = life.hours_high,
          .limit = life.limit,
          .tonnes = life.tonnes,
          .cycles = static_cast<double>(cycles_of(history).size()),
          .new_height = fresh.lifter_height,
          .height = last.lifter_height,
          .plate_thickness = last.plate_thickness,
          .worn_steel = steel * last.worn_volume,
          .worn_steel_error = steel * last.worn_volume_error,
          .power = fresh.power / slice,
          .power_error = fresh.power_error / slice,
          .bare_hit_power = fresh.bare_hit_power / slice,
          .bare_hit_power_error = fresh.bare_hit_power_error / slice,
          .shoulder = degrees_per_radian * fresh.shoulder,
          .shoulder_error = degrees_per_radian * fresh.shoulder_error,
          .toe = degrees_per_radian * fresh.toe,
          .toe_error = degrees_per_radian * fresh.toe_error};
}

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "-";
}

std::string cell(const Figures& figures, const Column& column) {
  const std::string value = number(column.per_unit * figures.*column.value, column.digits);
  const double error = column.error != nullptr ? figures.*column.error : nan;
  return std::isfinite(error)
             ? fmt::format("{} +- {}", value, number(column.per_unit * error, column.digits))
             : value;
}

std::string band_cell(const Figures& figures) {
  return std::isfinite(figures.life_hours_low)
             ? fmt::format("{:.0f} to {:.0f}", figures.life_hours_low, figures.life_hours_high)
             : "-";
}

/// Words, and a cell a campaign.
using Line = std::pair<std::string, std::vector<std::string>>;

std::vector<Line> lines_of(const Comparison& comparison) {
  std::vector<Line> lines;
  const auto add = [&](std::string words, const auto& cell_of) {
    lines.emplace_back(std::move(words), std::vector<std::string>{});
    for (const Figures& figures : comparison.figures)
      lines.back().second.push_back(cell_of(figures));
  };
  lines.emplace_back("", std::vector<std::string>{});
  for (const auto& campaign : comparison.campaigns) lines.back().second.push_back(campaign.name);
  add("life [h]", [](const Figures& figures) {
    return figures.worn_out ? number(figures.life_hours, 0)
                            : fmt::format("over {}", number(figures.life_hours, 0));
  });
  add("95 % band of the life [h]", band_cell);
  add("limit", [](const Figures& figures) { return figures.limit; });
  for (const auto& column : columns)
    add(std::string(column.text), [&](const Figures& figures) { return cell(figures, column); });
  for (const auto& [key, values] : comparison.differing) lines.emplace_back(key, values);
  return lines;
}

Json json_of(const ComparedCampaign& compared, const Figures& figures) {
  Json json{{"name", compared.name},
            {"folder", compared.campaign.folder.root.string()},
            {"worn_out", figures.worn_out},
            {"life_hours", figures.life_hours},
            {"life_hours_low", number_or_null(figures.life_hours_low)},
            {"life_hours_high", number_or_null(figures.life_hours_high)},
            {"limit", figures.limit}};
  for (const auto& column : columns) {
    json[std::string(column.name)] = number_or_null(figures.*column.value);
    if (column.error != nullptr)
      json[std::string(column.name) + "_se"] = number_or_null(figures.*column.error);
  }
  json["missing"] = compared.missing;
  return json;
}

}  // namespace

Comparison comparison_of(std::vector<ComparedCampaign> campaigns) {
  Comparison comparison{std::move(campaigns), {}, {}};
  std::vector<Case> cases;
  for (const auto& compared : comparison.campaigns) {
    comparison.figures.push_back(figures_of(compared));
    cases.push_back(compared.campaign.mill);
  }
  comparison.differing = differing_keys(cases);
  return comparison;
}

std::string comparison_text(const Comparison& comparison) {
  const auto lines = lines_of(comparison);
  std::vector<std::size_t> widths(comparison.campaigns.size() + 1, 0);
  for (const auto& [words, cells] : lines) {
    widths[0] = std::max(widths[0], words.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i + 1] = std::max(widths[i + 1], cells[i].size());
  }
  std::string text;
  for (const auto& [words, cells] : lines) {
    text += fmt::format("{:<{}}", words, widths[0]);
    for (std::size_t i = 0; i < cells.size(); ++i)
      text += fmt::format("  {:>{}}", cells[i], widths[i + 1]);
    text += '\n';
  }
  for (const auto& compared : comparison.campaigns)
    for (const auto& words : compared.missing)
      text += fmt::format("{}: {}\n", compared.name, words);
  return text;
}

std::string comparison_json(const Comparison& comparison) {
  Json campaigns = Json::array();
  for (std::size_t i = 0; i < comparison.campaigns.size(); ++i)
    campaigns.push_back(json_of(comparison.campaigns[i], comparison.figures[i]));
  Json differing = Json::array();
  for (const auto& [key, values] : comparison.differing)
    differing.push_back({{"key", key}, {"values", values}});
  return Json{{"campaigns", campaigns}, {"differing", differing}}.dump(
      1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace millwear::orchestrator
