#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "orchestrator/validation/published_figures.h"
#include "orchestrator/validation/simulated_figures.h"

namespace millwear::orchestrator {

/// An experiment: what was published of it, and what the program gives.
struct Validation {
  std::string name;
  std::vector<PublishedFigure> published;
  SimulatedFigures simulated;
};

/// The kept validation of a case's folder: `published.csv` and `simulated.csv`.
[[nodiscard]] Validation kept_validation(const std::filesystem::path& folder);

/// How a simulated figure stands to a published one: within two standard errors of both, else by
/// how much it is off, in percent, or for an angle in degrees.
[[nodiscard]] std::string verdict_of(const PublishedFigure& published, const Figure& simulated);

/// A Markdown table, a row a published figure, with its source.
[[nodiscard]] std::string validation_table(const std::vector<Validation>& validations);

}  // namespace millwear::orchestrator
