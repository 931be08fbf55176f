#pragma once
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "orchestrator/study/campaign_figures.h"
#include "orchestrator/study/run_campaigns.h"
#include "orchestrator/study/study_points.h"

namespace millwear::orchestrator {

/// A figure of a point, over its replicates that are done.
struct PointFigure {
  double mean;     ///< NaN where no replicate has it
  double error;    ///< standard error of the mean, as the replicates predict it; NaN unknown
  double scatter;  ///< standard deviation between the replicates; NaN for fewer than two
};

/// A point of a study with what is known of it.
struct PointResult {
  int done;                          ///< replicates
  int failed;                        ///< likewise
  std::vector<PointFigure> figures;  ///< one a `figure_columns()`
  PointFigure objective;             ///< NaN without an objective
  double probability_of_best;        ///< NaN without an objective
};

/// What a study knows so far.
struct StudyResults {
  StudyPlan plan;
  std::vector<std::filesystem::path> folders;           ///< of the campaigns
  std::vector<StateOfCampaign> states;                  ///< likewise
  std::vector<std::optional<CampaignFigures>> figures;  ///< likewise
  std::vector<PointResult> points;
  std::optional<std::size_t> best;  ///< the point with the best objective
};

/// A figure of a point by its column (std::logic_error where there is no such column).
[[nodiscard]] const PointFigure& figure_of(const PointResult& point, std::string_view name);

/// Standard deviation of a figure's mean: what is predicted, or what the replicates show where that
/// is more.
[[nodiscard]] double deviation_of(const PointResult& point, const PointFigure& figure);

/// Throws InputError where the objective or a limit names no figure.
void check_columns(const Study& study);

/// Gathers what the campaigns of a study have, point by point. A point is the best with the
/// probability that it is so in 10,000 draws of all points from normal distributions; their
/// standard deviation is the predicted error of the mean, or its scatter over the root of the
/// replicates where that is larger. Throws InputError where the objective names no figure.
[[nodiscard]] StudyResults study_results(const StudyPlan& plan,
                                         const std::vector<std::filesystem::path>& folders,
                                         const std::vector<StateOfCampaign>& states);

}  // namespace millwear::orchestrator
