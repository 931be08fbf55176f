#include "orchestrator/study/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mill/base/csv.h"
#include "mill/base/number_or_null.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format = "# millwear study 2\n";

/// A field of a CSV, in quotes where it needs them.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

int replicates_of(const StudyResults& results, std::size_t point) {
  return static_cast<int>(std::ranges::count_if(
      results.plan.campaigns, [point](const auto& campaign) { return campaign.point == point; }));
}

std::string figure_fields(const PointFigure& figure) {
  return fmt::format(",{},{},{}", csv_number(figure.mean), csv_number(figure.error),
                     csv_number(figure.scatter));
}

Json json_of(const PointFigure& figure) {
  return {{"mean", number_or_null(figure.mean)},
          {"se", number_or_null(figure.error)},
          {"scatter", number_or_null(figure.scatter)}};
}

std::string_view name_of(CampaignState state) {
  switch (state) {
    case CampaignState::done:
      return "done";
    case CampaignState::failed:
      return "failed";
    case CampaignState::waiting:
      return "waiting";
  }
  return "";
}

Json campaigns_json(const StudyResults& results, std::size_t point) {
  Json campaigns = Json::array();
  for (std::size_t i = 0; i < results.plan.campaigns.size(); ++i) {
    const auto& campaign = results.plan.campaigns[i];
    if (campaign.point != point) continue;
    Json figures = nullptr;
    if (results.figures[i]) {
      figures = Json::object();
      for (const FigureColumn& column : figure_columns())
        figures[std::string(column.name)] = {
            {"value", number_or_null(*results.figures[i].*column.value)},
            {"se", column.error != nullptr ? Json(number_or_null(*results.figures[i].*column.error))
                                           : Json(nullptr)}};
    }
    campaigns.push_back(
        {{"folder", results.folders[i].filename().string()},
         {"seed", campaign.seed},
         {"state", name_of(results.states[i].state)},
         {"has_report", std::filesystem::exists(RunFolder{results.folders[i]}.report())},
         {"wall_hours", results.figures[i] ? Json(wall_hours(results.folders[i])) : Json(nullptr)},
         {"figures", figures}});
  }
  return campaigns;
}

Json point_json(const StudyResults& results, std::size_t i) {
  const PointResult& point = results.points[i];
  Json values = Json::object();
  for (std::size_t axis = 0; axis < results.plan.study.axes.size(); ++axis)
    values[results.plan.study.axes[axis].key] = results.plan.points[i].labels[axis];
  Json figures = Json::object();
  for (std::size_t k = 0; k < figure_columns().size(); ++k)
    figures[std::string(figure_columns()[k].name)] = json_of(point.figures[k]);
  return {{"point", i + 1},
          {"values", values},
          {"replicates", replicates_of(results, i)},
          {"done", point.done},
          {"failed", point.failed},
          {"figures", figures},
          {"objective", json_of(point.objective)},
          {"probability_of_best", number_or_null(point.probability_of_best)},
          {"campaigns", campaigns_json(results, i)}};
}

/// A mean with its error, in as many digits as the error is worth.
std::string with_error(const PointFigure& figure, double unit) {
  if (std::isnan(figure.mean)) return "-";
  const double error = std::fmax(std::isfinite(figure.error) ? figure.error : 0.0, 0.0) * unit;
  if (error == 0.0) return fmt::format("{:.5g}", unit * figure.mean);
  const int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6);
  return fmt::format("{:.{}f} +- {:.2g}", unit * figure.mean, digits, error);
}

}  // namespace

std::string study_csv(const StudyResults& results) {
  std::string text(format);
  text += "point";
  for (const StudyAxis& axis : results.plan.study.axes) text += "," + field(axis.key);
  text += ",replicates,done,failed";
  for (const FigureColumn& column : figure_columns())
    text += fmt::format(",{0},{0}_se,{0}_scatter", column.name);
  text += ",objective,objective_se,objective_scatter,probability_of_best\n";
  for (std::size_t i = 0; i < results.points.size(); ++i) {
    const PointResult& point = results.points[i];
    text += std::to_string(i + 1);
    for (const std::string& label : results.plan.points[i].labels) text += "," + field(label);
    text += fmt::format(",{},{},{}", replicates_of(results, i), point.done, point.failed);
    for (const PointFigure& figure : point.figures) text += figure_fields(figure);
    text += figure_fields(point.objective) + "," + csv_number(point.probability_of_best) + "\n";
  }
  return text;
}

std::string study_json(const StudyResults& results) {
  return study_document(results).dump(1) + "\n";
}

Json study_document(const StudyResults& results) {
  Json points = Json::array();
  for (std::size_t i = 0; i < results.points.size(); ++i) points.push_back(point_json(results, i));
  Json axes = Json::array();
  for (const StudyAxis& axis : results.plan.study.axes) axes.push_back(axis.key);
  Json columns = Json::array();
  for (const FigureColumn& column : figure_columns())
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"doc", column.doc}});
  const auto& objective = results.plan.study.objective;
  return Json{{"type", "millwear study"},
              {"format_version", 1},
              {"name", results.plan.study.name},
              {"base_case", results.plan.base.name},
              {"axes", axes},
              {"objective", objective ? Json(spoken(*objective)) : Json(nullptr)},
              {"best", results.best ? Json(*results.best + 1) : Json(nullptr)},
              {"columns", columns},
              {"points", points}};
}

std::string study_text(const StudyResults& results) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> head{"point"};
  for (const StudyAxis& axis : results.plan.study.axes) head.push_back(axis.key);
  for (const char* const name : {"done", "life [h]", "height [mm]", "plate [mm]", "power [kW]"})
    head.emplace_back(name);
  const auto& objective = results.plan.study.objective;
  if (objective) {
    head.push_back(spoken(*objective));
    head.emplace_back("best");
  }
  rows.push_back(head);
  for (std::size_t i = 0; i < results.points.size(); ++i) {
    const PointResult& point = results.points[i];
    std::vector<std::string> row{std::to_string(i + 1)};
    for (const std::string& label : results.plan.points[i].labels) row.push_back(label);
    row.push_back(fmt::format("{}/{}", point.done, replicates_of(results, i)));
    row.push_back(with_error(figure_of(point, "life_hours"), 1.0));
    row.push_back(with_error(figure_of(point, "lifter_height_m"), 1e3));
    row.push_back(with_error(figure_of(point, "plate_thickness_m"), 1e3));
    row.push_back(with_error(figure_of(point, "power_w"), 1e-3));
    if (objective) {
      row.push_back(with_error(point.objective, 1.0));
      row.push_back(std::isnan(point.probability_of_best)
                        ? "-"
                        : fmt::format("{:.0f} %", 100.0 * point.probability_of_best));
    }
    rows.push_back(row);
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      std::size_t width = 0;
      for (const auto& other : rows) width = std::max(width, other[column].size());
      line += fmt::format("{:>{}}  ", row[column], width);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace millwear::orchestrator
