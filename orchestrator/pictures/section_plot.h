#pragma once
#include <Eigen/Core>
#include <string>

#include "orchestrator/charge/charge_of_cycle.h"

namespace millwear::orchestrator {

inline constexpr int section_plot_width = 620;  ///< of one panel with its colour bar [px]

/// gnuplot's commands for one or more panels side by side: terminal and layout.
[[nodiscard]] std::string section_terminal(int panels);

/// The same for one panel as JPEG, without a colour bar.
[[nodiscard]] std::string section_jpeg_terminal();

/// A block of the values of a map, for `with image`: x, z and value, cell by cell; what is
/// not known is left out.
[[nodiscard]] std::string map_block(const std::string& name, const wear::SectionGrid& grid,
                                    const Eigen::VectorXd& values);

/// Commands of one panel: equal scales, the circles of shell and crests, a colour bar to `end`
/// (from zero) with `words`; `plots` follow `plot`, the first without a comma.
[[nodiscard]] std::string section_panel(const ChargeOfCycle& charge, const std::string& words,
                                        double low, double end, const std::string& plots);

}  // namespace millwear::orchestrator
