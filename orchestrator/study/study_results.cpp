#include "orchestrator/study/study_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/contract.h"
#include "mill/base/failure.h"
#include "mill/base/nearest_word.h"
#include "mill/case_file/case_file.h"
#include "wear/band/repeats.h"
#include "wear/numerics/random_stream.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Eigen::Index draws = 10000;
constexpr Eigen::Index draws_at_once = 100;  // so that memory does not grow with points times draws
constexpr std::uint64_t draw_seed = 1;

/// A value of one campaign with its standard error.
struct Value {
  double value;
  double error;
};

PointFigure over_replicates(const std::vector<Value>& replicates) {
  if (replicates.empty()) return {nan, nan, nan};
  std::vector<double> values;
  std::vector<double> errors;
  for (const Value& one : replicates) {
    values.push_back(one.value);
    errors.push_back(one.error);
  }
  const auto [mean, scatter, predicted] = wear::repeats_of(values, errors);
  return {mean, predicted / std::sqrt(static_cast<double>(values.size())), scatter};
}

const FigureColumn& figure_named(const Study& study, const std::string& name) {
  std::vector<std::string_view> known;
  for (const FigureColumn& column : figure_columns()) {
    if (column.name == name) return column;
    known.push_back(column.name);
  }
  const std::string near = nearest_word(name, known);
  throw InputError(
      fmt::format("{}: `{}` is no column of study.csv; {}", study.file.string(), name,
                  near.empty() ? "`life_hours` is one" : fmt::format("did you mean `{}`?", near)));
}

/// The objective of one campaign; the errors of a ratio's two figures as independent.
Value objective_of(const Study& study, const CampaignFigures& figures) {
  const auto value = [&](const FigureColumn& column) {
    return Value{figures.*column.value, column.error != nullptr ? figures.*column.error : 0.0};
  };
  const Value result = value(figure_named(study, study.objective->result));
  if (study.objective->divisor.empty()) return result;
  const Value divisor = value(figure_named(study, study.objective->divisor));
  const double ratio = result.value / divisor.value;
  return {ratio,
          std::abs(ratio) * std::hypot(result.error / result.value, divisor.error / divisor.value)};
}

PointResult point_result(const StudyResults& results, std::size_t point) {
  PointResult made{0, 0, {}, {nan, nan, nan}, nan};
  std::vector<const CampaignFigures*> figures;
  for (std::size_t i = 0; i < results.plan.campaigns.size(); ++i) {
    if (results.plan.campaigns[i].point != point) continue;
    made.failed += results.states[i].state == CampaignState::failed ? 1 : 0;
    if (results.figures[i]) figures.push_back(&*results.figures[i]);
  }
  made.done = static_cast<int>(figures.size());
  for (const FigureColumn& column : figure_columns()) {
    std::vector<Value> values;
    for (const CampaignFigures* const one : figures)
      values.push_back({one->*column.value, column.error != nullptr ? one->*column.error : nan});
    made.figures.push_back(over_replicates(values));
  }
  if (!results.plan.study.objective) return made;
  std::vector<Value> values;
  for (const CampaignFigures* const one : figures)
    values.push_back(objective_of(results.plan.study, *one));
  made.objective = over_replicates(values);
  return made;
}

void find_best(StudyResults& results) {
  const double sign =
      results.plan.study.objective->sense == Objective::Sense::maximise ? 1.0 : -1.0;
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < results.points.size(); ++i)
    if (std::isfinite(results.points[i].objective.mean)) known.push_back(i);
  if (known.empty()) return;
  results.best = *std::ranges::max_element(
      known, {}, [&](std::size_t i) { return sign * results.points[i].objective.mean; });
  const auto count = static_cast<Eigen::Index>(known.size());
  Eigen::ArrayXd means(count);
  Eigen::ArrayXd deviations(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const PointResult& point = results.points[known[static_cast<std::size_t>(k)]];
    means[k] = sign * point.objective.mean;
    deviations[k] = deviation_of(point, point.objective);
  }
  Eigen::ArrayXd wins = Eigen::ArrayXd::Zero(count);
  for (Eigen::Index done = 0; done < draws; done += draws_at_once) {
    const auto chances = wear::standard_normals(count, draws_at_once, draw_seed,
                                                static_cast<std::uint64_t>(done * count));
    for (Eigen::Index draw = 0; draw < draws_at_once; ++draw) {
      Eigen::Index winner = 0;
      (means + deviations * chances.col(draw).array()).maxCoeff(&winner);
      ++wins[winner];
    }
  }
  for (Eigen::Index k = 0; k < count; ++k)
    results.points[known[static_cast<std::size_t>(k)]].probability_of_best =
        wins[k] / static_cast<double>(draws);
}

}  // namespace

const PointFigure& figure_of(const PointResult& point, std::string_view name) {
  const auto columns = figure_columns();
  const auto found = std::ranges::find(columns, name, &FigureColumn::name);
  expect(found != columns.end(), "a figure of a point is one of the columns");
  return point.figures.at(static_cast<std::size_t>(found - columns.begin()));
}

double deviation_of(const PointResult& point, const PointFigure& figure) {
  const double shown = figure.scatter / std::sqrt(static_cast<double>(point.done));
  return std::fmax(std::isfinite(figure.error) ? figure.error : 0.0,
                   std::isfinite(shown) ? shown : 0.0);
}

void check_columns(const Study& study) {
  for (const Limit& limit : study.limits) static_cast<void>(figure_named(study, limit.result));
  if (!study.objective) return;
  static_cast<void>(figure_named(study, study.objective->result));
  if (!study.objective->divisor.empty())
    static_cast<void>(figure_named(study, study.objective->divisor));
}

StudyResults study_results(const StudyPlan& plan, const std::vector<std::filesystem::path>& folders,
                           const std::vector<StateOfCampaign>& states) {
  StudyResults results{plan, folders, states, {}, {}, std::nullopt};
  check_columns(plan.study);
  for (std::size_t i = 0; i < plan.campaigns.size(); ++i) {
    results.figures.emplace_back();
    if (states[i].state == CampaignState::done)
      results.figures.back() = figures_of(
          folders[i], case_from_text(plan.campaigns[i].case_text, folders[i] / "case.toml"));
  }
  for (std::size_t point = 0; point < plan.points.size(); ++point)
    results.points.push_back(point_result(results, point));
  if (plan.study.objective) find_best(results);
  return results;
}

}  // namespace millwear::orchestrator
