#include "orchestrator/calibration/course_replicates.h"

#include <fmt/format.h>

#include <algorithm>

#include "mill/base/failure.h"
#include "wear/numerics/random_stream.h"

namespace millwear::orchestrator {
namespace {

/// Of the errors drawn for the readings.
constexpr std::uint64_t seed = 20060211;
/// How far replicates go on, in lengths of the campaign.
constexpr double times_as_long = 4.0;

void check_rows(const CampaignCourse& campaign) {
  const auto same = [](const HistoryRow& row, const ReplicateRow& replicate) {
    return row.cycle == replicate.cycle && row.step == replicate.step &&
           row.operating_hours == replicate.operating_hours;
  };
  if (!std::equal(campaign.history.begin(), campaign.history.end(), campaign.replicates.begin(),
                  campaign.replicates.end(), same))
    throw ResultRejected(
        "replicates.csv is not of the same steps as history.csv; write both anew with `millwear "
        "report`, or take both from one campaign");
}

/// When the last load was measured, in the campaign's hours.
double hours_of_last_load(const std::vector<HistoryRow>& history) {
  const auto first_of_last = std::ranges::find(history, history.back().cycle, &HistoryRow::cycle);
  return first_of_last == history.begin() ? first_of_last->operating_hours
                                          : (first_of_last - 1)->operating_hours;
}

/// Rows are moments, columns replicates; a moment more at the end, far ahead.
Eigen::MatrixXd gone_on(const std::vector<double>& hours, Eigen::MatrixXd values,
                        double last_load) {
  const double speed = wear::mean_speed(hours, values, last_load);
  const Eigen::Index end = values.rows();
  values.conservativeResize(end + 1, Eigen::NoChange);
  values.row(end) = values.row(end - 1).array() - speed * (times_as_long - 1.0) * hours.back();
  return values;
}

template <class Quantity>
wear::Band band_over(const CalibratedReplicates& replicates, Quantity quantity) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(replicates.courses.size()));
  for (std::size_t r = 0; r < replicates.courses.size(); ++r)
    values[static_cast<Eigen::Index>(r)] = quantity(replicates.courses[r], replicates.factors[r]);
  return wear::band_of(values);
}

std::vector<CourseQuantities> replicate_courses(const CampaignCourse& campaign, GaugeOn gauge) {
  const auto moments = static_cast<Eigen::Index>(campaign.replicates.size());
  Eigen::MatrixXd heights(moments, campaign.replicates.front().heights.size());
  Eigen::MatrixXd plates = heights;
  std::vector<double> hours;
  for (const ReplicateRow& row : campaign.replicates) {
    const auto moment = static_cast<Eigen::Index>(hours.size());
    heights.row(moment) = row.heights;
    plates.row(moment) = row.plates;
    hours.push_back(row.operating_hours);
  }
  const double last_load = hours_of_last_load(campaign.history);
  heights = gone_on(hours, std::move(heights), last_load);
  plates = gone_on(hours, std::move(plates), last_load);
  hours.push_back(times_as_long * hours.back());
  const Eigen::VectorXd times = Eigen::Map<const Eigen::VectorXd>(hours.data(), moments + 1);
  std::vector<CourseQuantities> courses;
  for (Eigen::Index r = 0; r < heights.cols(); ++r) {
    const wear::Course height{times, heights.col(r)};
    const wear::Course plate{times, plates.col(r)};
    courses.push_back({height, plate, as_read(height, plate, gauge)});
  }
  return courses;
}

}  // namespace

wear::Course as_read(const wear::Course& height, const wear::Course& plate, GaugeOn gauge) {
  if (gauge == GaugeOn::new_plate) return height;
  return {height.times, height.values.array() + (plate.values[0] - plate.values.array())};
}

CalibratedReplicates calibrated_replicates(const CampaignCourse& campaign,
                                           std::span<const wear::DatedLength> heights,
                                           GaugeOn gauge) {
  if (campaign.replicates.empty()) return {};
  check_rows(campaign);
  CalibratedReplicates replicates{replicate_courses(campaign, gauge), {}};
  const Eigen::MatrixXd errors =
      wear::standard_normals(static_cast<Eigen::Index>(heights.size()),
                             static_cast<Eigen::Index>(replicates.courses.size()), seed);
  for (std::size_t r = 0; r < replicates.courses.size(); ++r) {
    std::vector<wear::DatedLength> read(heights.begin(), heights.end());
    for (std::size_t i = 0; i < read.size(); ++i)
      read[i].value +=
          read[i].error * errors(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(r));
    replicates.factors.push_back(wear::factor_of(replicates.courses[r].gauge, read).factor);
  }
  return replicates;
}

wear::Band factor_band(const CalibratedReplicates& replicates) {
  return band_over(replicates, [](const CourseQuantities&, double factor) { return factor; });
}

wear::Band band_at(const CalibratedReplicates& replicates, wear::Course CourseQuantities::*quantity,
                   double hours) {
  return band_over(replicates, [&](const CourseQuantities& own, double factor) {
    return wear::value_at(own.*quantity, factor * hours);
  });
}

wear::Band life_band(const CalibratedReplicates& replicates, double height_limit) {
  return band_over(replicates, [&](const CourseQuantities& own, double factor) {
    return wear::time_of(own.height, height_limit) / factor;
  });
}

}  // namespace millwear::orchestrator
