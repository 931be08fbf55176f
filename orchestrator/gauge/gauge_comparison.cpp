#include "orchestrator/gauge/gauge_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mill/base/csv.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"

namespace millwear::orchestrator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr CsvFormat format{
    "millwear comparison 1",
    "operating_hours,lifter_height_m_measured,lifter_height_m_predicted,error_m,"
    "face_angle_deg_measured,face_angle_deg_predicted,plate_thickness_m_measured,"
    "plate_thickness_m_predicted,profile_hours,signed_area_m2,absolute_area_m2,rms_distance_m,"
    "hausdorff_m"};

/// The rows before and after a date; none where the campaign does not reach it.
std::optional<Prediction> prediction_at(const std::vector<HistoryRow>& history, double hours) {
  const auto after =
      std::lower_bound(history.begin(), history.end(), hours,
                       [](const HistoryRow& row, double at) { return row.operating_hours < at; });
  if (after == history.end() || (after == history.begin() && after->operating_hours > hours))
    return std::nullopt;
  const auto before = after == history.begin() ? after : after - 1;
  const double between = after->operating_hours - before->operating_hours;
  const double share = between > 0.0 ? (hours - before->operating_hours) / between : 1.0;
  const auto at = [&](double HistoryRow::*value) {
    return (1.0 - share) * (*before).*value + share * (*after).*value;
  };
  return Prediction{at(&HistoryRow::lifter_height), at(&HistoryRow::face_angle),
                    at(&HistoryRow::plate_thickness),
                    (share < 0.5 ? before : after)->operating_hours};
}

LinerProfile profile_at(const std::vector<ProfileRow>& profiles, double hours,
                        const LinerSector& sector) {
  const auto found = std::find_if(profiles.begin(), profiles.end(), [&](const ProfileRow& row) {
    return row.operating_hours == hours;
  });
  if (found == profiles.end())
    throw ResultRejected(fmt::format(
        "profiles.csv has no profile at the {:g} h of history.csv; write both anew with `millwear "
        "report`",
        hours));
  return {sector, found->nodes};
}

}  // namespace

std::vector<ReadingComparison> compare_with(const std::vector<GaugeReading>& readings,
                                            const std::vector<HistoryRow>& history,
                                            const std::vector<ProfileRow>& profiles,
                                            const LinerSector& sector) {
  std::vector<ReadingComparison> comparisons;
  for (const GaugeReading& reading : readings) {
    ReadingComparison comparison{reading, prediction_at(history, reading.operating_hours), {}};
    if (comparison.predicted && reading.profile)
      comparison.difference = wear::compare(
          profile_at(profiles, comparison.predicted->profile_hours, sector), *reading.profile);
    comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

double rms_of_heights(const std::vector<ReadingComparison>& comparisons) {
  double sum = 0.0;
  int count = 0;
  for (const auto& comparison : comparisons) {
    if (!comparison.predicted || !comparison.measured.lifter_height) continue;
    sum += std::pow(comparison.predicted->lifter_height - *comparison.measured.lifter_height, 2);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / count) : nan;
}

std::string comparison_csv(const std::vector<ReadingComparison>& comparisons) {
  std::string text = csv_head(format);
  for (const auto& [measured, predicted, difference] : comparisons) {
    const auto of_prediction = [&, &from = predicted](double Prediction::*value) {
      return from ? (*from).*value : nan;
    };
    const auto of_difference = [&, &from = difference](double wear::ProfileDifference::*value) {
      return from ? (*from).*value : nan;
    };
    const double measured_face = measured.profile ? leading_face_angle(*measured.profile) : nan;
    using D = wear::ProfileDifference;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_number(measured.operating_hours),
        csv_number(measured.lifter_height.value_or(nan)),
        csv_number(of_prediction(&Prediction::lifter_height)), csv_number(measured.error),
        csv_degrees(measured_face), csv_degrees(of_prediction(&Prediction::face_angle)),
        csv_number(measured.plate_thickness.value_or(nan)),
        csv_number(of_prediction(&Prediction::plate_thickness)),
        csv_number(of_prediction(&Prediction::profile_hours)),
        csv_number(of_difference(&D::signed_area)), csv_number(of_difference(&D::absolute_area)),
        csv_number(of_difference(&D::rms_distance)), csv_number(of_difference(&D::hausdorff)));
  }
  return text;
}

}  // namespace millwear::orchestrator
