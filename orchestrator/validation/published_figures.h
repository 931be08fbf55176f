#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "orchestrator/validation/figure.h"

namespace millwear::orchestrator {

/// A published figure of an experiment.
struct PublishedFigure {
  Quantity quantity;
  Figure figure;                        ///< its error is the source's, or as far as it can be read
  std::optional<double> mill_length;    ///< of a power: of the mill that drew it [m]
  std::optional<double> lifter_height;  ///< of a face angle: that the lifter had worn to [m]
  std::string source;                   ///< who published it, where
};

/// The table `published.csv` of a validation case: columns
/// `quantity,value,error,mill_length_m,lifter_height_m,source` and comments behind `#`. A field of
/// error, length or height may be empty. Throws InputError (file:line) for an unknown quantity, a
/// value that is no number, a power without a length, a face angle without a height, and a figure
/// without a source.
[[nodiscard]] std::vector<PublishedFigure> read_published_figures(
    const std::filesystem::path& file);

}  // namespace millwear::orchestrator
