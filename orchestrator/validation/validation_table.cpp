#include "orchestrator/validation/validation_table.h"

#include <fmt/format.h>

#include <cmath>

namespace millwear::orchestrator {
namespace {

bool is_angle(Quantity quantity) { return name_of(quantity).unit == "°"; }

double squared(double error) { return std::isnan(error) ? 0.0 : error * error; }

/// "72.8 ± 0.3", to four digits of the value.
std::string spoken(const Figure& figure, double unit) {
  if (std::isnan(figure.error)) return fmt::format("{:.4g}", figure.value / unit);
  return fmt::format("{:.4g} ± {:.2g}", figure.value / unit, figure.error / unit);
}

/// The power of a plant is told in megawatts.
bool is_of_a_plant(const PublishedFigure& published) {
  constexpr double least = 1e5;  // W
  return published.quantity == Quantity::power && published.figure.value >= least;
}

std::string row_text(const std::string& experiment, const PublishedFigure& published,
                     const Figure& simulated) {
  const auto& name = name_of(published.quantity);
  const bool is_large = is_of_a_plant(published);
  const double unit = is_large ? 1e6 : 1.0;
  return fmt::format("| {} | {}, {} | {} | {} | {} | {} |\n", experiment, name.words,
                     is_large ? "MW" : name.unit, spoken(published.figure, unit),
                     spoken(simulated, unit), verdict_of(published, simulated), published.source);
}

}  // namespace

Validation kept_validation(const std::filesystem::path& folder) {
  return {std::filesystem::canonical(folder).filename().string(),
          read_published_figures(folder / "published.csv"),
          read_simulated_csv(folder / "simulated.csv")};
}

std::string verdict_of(const PublishedFigure& published, const Figure& simulated) {
  const double off = simulated.value - published.figure.value;
  const double error = std::sqrt(squared(published.figure.error) + squared(simulated.error));
  const std::string amount = is_angle(published.quantity)
                                 ? fmt::format("{:+.1f}°", off)
                                 : fmt::format("{:+.1f} %", 100.0 * off / published.figure.value);
  if (std::isnan(off)) return "not found";
  return fmt::format("{} ({})", std::abs(off) <= 2.0 * error ? "agrees" : "off", amount);
}

std::string validation_table(const std::vector<Validation>& validations) {
  std::string text =
      "| experiment | quantity | published | simulated | verdict | source |\n"
      "|---|---|---|---|---|---|\n";
  for (const Validation& one : validations)
    for (const PublishedFigure& published : one.published)
      text += row_text(one.name, published, one.simulated.at(published.quantity));
  return text;
}

}  // namespace millwear::orchestrator
