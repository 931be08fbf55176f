#include "orchestrator/study/coverage.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "mill/base/contract.h"
#include "mill/base/csv_columns.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/results/history.h"
#include "wear/band/life_band.h"
#include "wear/band/repeats.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t fewest_campaigns = 3;

constexpr std::string_view courses_format = "millwear seeds 2";
constexpr std::array<CsvColumn<SeedMoment>, 9> course_columns{{
    {"seed", "1", "", "", &SeedMoment::seed},
    {"operating_hours", "h", "", "", &SeedMoment::hours},
    {"lifter_height_m", "m", "", "", &SeedMoment::height},
    {"lifter_height_m_se", "m", "", "", &SeedMoment::height_error},
    {"plate_thickness_m", "m", "", "", &SeedMoment::plate},
    {"plate_thickness_m_se", "m", "", "", &SeedMoment::plate_error},
    {"worn_volume_m3_per_m", "m3/m", "", "", &SeedMoment::volume},
    {"worn_volume_m3_per_m_se", "m3/m", "", "", &SeedMoment::volume_error},
    {"roughness_m", "m", "", "", &SeedMoment::roughness},
}};
constexpr std::string_view lives_format = "millwear lives 1";
constexpr std::array<CsvColumn<SeedLife>, 4> life_columns{{
    {"seed", "1", "", "", &SeedLife::seed},
    {"life_hours", "h", "", "", &SeedLife::hours},
    {"life_hours_low", "h", "", "", &SeedLife::low},
    {"life_hours_high", "h", "", "", &SeedLife::high},
}};

/// A measure and its predicted error, in the unit that the table prints.
struct Measure {
  const char* name;
  double unit;
  double SeedMoment::*value;
  double SeedMoment::*error;
};
constexpr std::array measures{
    Measure{"volume, cm3/m", 1e-6, &SeedMoment::volume, &SeedMoment::volume_error},
    Measure{"height, mm", 1e-3, &SeedMoment::height, &SeedMoment::height_error},
    Measure{"plate, mm", 1e-3, &SeedMoment::plate, &SeedMoment::plate_error}};

/// Values of one measure with their predicted errors, a value a campaign.
struct Sample {
  Eigen::ArrayXd values;
  Eigen::ArrayXd errors;
};

std::span<const double> as_span(const Eigen::ArrayXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

Coverage compared(std::string measure, double hours, const Sample& sample) {
  const auto n = static_cast<double>(sample.values.size());
  const auto [mean, scatter, predicted] =
      wear::repeats_of(as_span(sample.values), as_span(sample.errors));
  const Eigen::ArrayXd squares = sample.errors.square();
  const double of_squares =
      std::sqrt((squares - squares.mean()).square().sum() / (n - 1.0) / n) / squares.mean();
  const double ratio = predicted / scatter;
  return {std::move(measure),
          hours,
          mean,
          scatter,
          predicted,
          ratio,
          ratio * std::hypot(1.0 / std::sqrt(2.0 * (n - 1.0)), 0.5 * of_squares)};
}

std::vector<SeedMoment> course_of(const Seeds& seeds, int seed) {
  std::vector<SeedMoment> course;
  std::ranges::copy_if(seeds.moments, std::back_inserter(course),
                       [seed](const SeedMoment& moment) { return moment.seed == seed; });
  return course;
}

double value_at(const std::vector<SeedMoment>& course, double hours, double SeedMoment::*value) {
  const auto after = std::ranges::find_if(
      course, [hours](const SeedMoment& moment) { return moment.hours >= hours; });
  if (after == course.begin()) return course.front().*value;
  if (after == course.end()) return course.back().*value;
  const auto before = after - 1;
  const double share = (hours - before->hours) / (after->hours - before->hours);
  return std::lerp((*before).*value, (*after).*value, share);
}

Sample sample_at(const std::vector<std::vector<SeedMoment>>& courses, double hours,
                 const Measure& measure) {
  const auto n = static_cast<Eigen::Index>(courses.size());
  Sample sample{Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& course = courses[static_cast<std::size_t>(i)];
    sample.values[i] = value_at(course, hours, measure.value) / measure.unit;
    sample.errors[i] = value_at(course, hours, measure.error) / measure.unit;
  }
  return sample;
}

Sample sample_of(const std::vector<SeedLife>& lives) {
  const auto n = static_cast<Eigen::Index>(lives.size());
  Sample sample{Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& life = lives[static_cast<std::size_t>(i)];
    sample.values[i] = life.hours;
    sample.errors[i] = wear::standard_error_of({life.low, life.high});
  }
  return sample;
}

}  // namespace

std::vector<Coverage> coverage_of(const Seeds& seeds) {
  expect(seeds.lives.size() >= fewest_campaigns, "a scatter takes three campaigns or more");
  std::vector<std::vector<SeedMoment>> courses;
  double shortest = std::numeric_limits<double>::infinity();
  for (const SeedLife& life : seeds.lives) {
    courses.push_back(course_of(seeds, life.seed));
    shortest = std::min(shortest, courses.back().back().hours);
  }
  std::vector<Coverage> rows;
  for (const Measure& measure : measures)
    for (const double share : {0.25, 0.5, 0.75, 1.0})
      rows.push_back(
          compared(measure.name, share * shortest, sample_at(courses, share * shortest, measure)));
  rows.push_back(compared("life, h", std::nan(""), sample_of(seeds.lives)));
  return rows;
}

double greatest_rise_of_roughness(const std::vector<SeedMoment>& moments) {
  double greatest = 0.0;
  double least = std::numeric_limits<double>::infinity();
  int seed = -1;
  for (const SeedMoment& moment : moments) {
    if (moment.seed != seed) least = std::numeric_limits<double>::infinity();
    seed = moment.seed;
    least = std::min(least, moment.roughness);
    greatest = std::max(greatest, moment.roughness - least);
  }
  return greatest;
}

std::string coverage_text(const std::vector<Coverage>& rows, std::size_t campaigns) {
  std::string text = fmt::format(
      "{} campaigns that differ in the seed. predicted: root mean square of the predicted "
      "standard\n"
      "errors; scatter: standard deviation between the campaigns.\n\n"
      "{:<14} {:>8} {:>9} {:>9} {:>10}   predicted / scatter\n",
      campaigns, "measure", "at hours", "mean", "scatter", "predicted");
  for (const Coverage& row : rows)
    text += fmt::format("{:<14} {:>8} {:>9.5g} {:>9.3g} {:>10.3g}   {:.2f} +- {:.2f}\n",
                        row.measure, std::isnan(row.hours) ? "" : fmt::format("{:.0f}", row.hours),
                        row.mean, row.scatter, row.predicted, row.ratio, row.ratio_error);
  return text;
}

Seeds seeds_of_runs(const std::vector<fs::path>& runs) {
  Seeds seeds;
  for (const fs::path& run : runs) {
    const auto summary = nlohmann::json::parse(read_file(run / "results" / "summary.json"));
    const int seed = summary.at("seed").get<int>();
    for (const HistoryRow& row : read_history_csv(run / "results" / "history.csv"))
      seeds.moments.push_back({seed, row.operating_hours, row.lifter_height,
                               row.lifter_height_error, row.plate_thickness,
                               row.plate_thickness_error, row.worn_volume, row.worn_volume_error,
                               row.roughness});
    seeds.lives.push_back({seed, summary.at("life_hours").get<double>(),
                           summary.at("life_hours_low").get<double>(),
                           summary.at("life_hours_high").get<double>()});
  }
  return seeds;
}

Seeds read_seeds(const fs::path& folder) {
  return {read_csv_table<SeedMoment>(folder / "courses.csv", courses_format, course_columns),
          read_csv_table<SeedLife>(folder / "lives.csv", lives_format, life_columns)};
}

void write_seeds(const fs::path& folder, const Seeds& seeds) {
  fs::create_directories(folder);
  publish(folder / "courses.csv",
          csv_table<SeedMoment>(courses_format, course_columns, seeds.moments));
  publish(folder / "lives.csv", csv_table<SeedLife>(lives_format, life_columns, seeds.lives));
}

}  // namespace millwear::orchestrator
