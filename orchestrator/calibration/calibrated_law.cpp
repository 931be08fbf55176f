#include "orchestrator/calibration/calibrated_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mill/base/constants.h"
#include "mill/base/failure.h"
#include "mill/liner/profile_measures.h"
#include "orchestrator/calibration/campaign_path.h"
#include "orchestrator/calibration/reapplied_law.h"
#include "orchestrator/campaign/case_difference.h"
#include "orchestrator/campaign/open_campaign.h"
#include "wear/calibrate/angular_zones.h"
#include "wear/calibrate/path_prediction.h"

namespace millwear::orchestrator {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr Eigen::Index zones = 12;
constexpr double errors_beyond = 2.0;
constexpr std::array uses = {ReadingUse::fitted, ReadingUse::shown, ReadingUse::held_out};
constexpr std::array quantities = {MeasuredQuantity::lifter_height,
                                   MeasuredQuantity::plate_thickness,
                                   MeasuredQuantity::worn_section};

/// A value that a reading shows, as a loss since new.
struct ShownLoss {
  std::size_t reading;
  MeasuredQuantity quantity;
  ReadingUse use;
  double lost;
  double error;
};

/// Whether the campaign has worn its liner as far as a reading, within two of its errors: to leave
/// out every reading that noise puts behind the end would favour the slow ones.
bool reached_by(const wear::WearPath& path, const GaugeReading& reading,
                const LinerProfile& fresh) {
  const double error = errors_beyond * reading.error;
  if (reading.profile)
    return steel_area(fresh) - steel_area(*reading.profile) <=
           path.lost.head(zones).sum() + error * arc_lengths(*reading.profile).back();
  if (reading.lifter_height)
    return lifter_height(fresh) - *reading.lifter_height <=
           path.lost[path.channels.height()] + error;
  return plate_thickness(fresh) - *reading.plate_thickness <=
         path.lost[path.channels.plate()] + error;
}

ReadingUse use_of(const wear::WearPath& path, const GaugeReading& reading,
                  const LinerProfile& fresh, std::optional<double> until) {
  if (!reached_by(path, reading, fresh)) return ReadingUse::beyond_campaign;
  return until && reading.operating_hours > *until ? ReadingUse::held_out : ReadingUse::fitted;
}

/// What a fitted reading gives to the fit: the zones of its profile, or else its lengths.
void observe(const GaugeReading& reading, std::size_t number, const LinerProfile& fresh,
             std::vector<wear::LossObservation>& observations) {
  const double time = reading.operating_hours * seconds_per_hour;
  const wear::PathChannels channels{zones};
  if (reading.profile) {
    const Eigen::VectorXd lost =
        wear::steel_by_zone(fresh, zones) - wear::steel_by_zone(*reading.profile, zones);
    const Eigen::VectorXd lengths = wear::length_by_zone(*reading.profile, zones);
    for (Eigen::Index zone = 0; zone < zones; ++zone)
      observations.push_back({number, time, zone, lost[zone], reading.error * lengths[zone]});
    return;
  }
  if (reading.lifter_height)
    observations.push_back({number, time, channels.height(),
                            lifter_height(fresh) - *reading.lifter_height, reading.error});
  if (reading.plate_thickness)
    observations.push_back({number, time, channels.plate(),
                            plate_thickness(fresh) - *reading.plate_thickness, reading.error});
}

std::vector<ShownLoss> shown_losses(const GaugeReading& reading, std::size_t number, ReadingUse use,
                                    const LinerProfile& fresh) {
  const ReadingUse beside = reading.profile && use == ReadingUse::fitted ? ReadingUse::shown : use;
  std::vector<ShownLoss> shown;
  if (reading.profile)
    shown.push_back({number, MeasuredQuantity::worn_section, use,
                     steel_area(fresh) - steel_area(*reading.profile),
                     reading.error * arc_lengths(*reading.profile).back()});
  if (reading.lifter_height)
    shown.push_back({number, MeasuredQuantity::lifter_height, beside,
                     lifter_height(fresh) - *reading.lifter_height, reading.error});
  if (reading.plate_thickness)
    shown.push_back({number, MeasuredQuantity::plate_thickness, beside,
                     plate_thickness(fresh) - *reading.plate_thickness, reading.error});
  return shown;
}

double loss_of(const wear::PathLoss& loss, MeasuredQuantity quantity) {
  const wear::PathChannels channels{zones};
  switch (quantity) {
    case MeasuredQuantity::lifter_height:
      return loss.lost[channels.height()];
    case MeasuredQuantity::plate_thickness:
      return loss.lost[channels.plate()];
    case MeasuredQuantity::worn_section:
      return loss.lost.head(zones).sum();
  }
  throw std::logic_error("a quantity of no kind");
}

/// The straight lines through what is shown of the fitted readings, by quantity.
Eigen::VectorXd lines(const std::vector<ShownLoss>& shown,
                      const std::vector<GaugeReading>& readings,
                      std::optional<std::size_t> without) {
  std::vector<wear::LossObservation> points;
  for (const auto& loss : shown)
    if (loss.use == ReadingUse::fitted || loss.use == ReadingUse::shown)
      points.push_back({loss.reading, readings[loss.reading].operating_hours,
                        static_cast<Eigen::Index>(loss.quantity), loss.lost, loss.error});
  return wear::straight_line(points, static_cast<Eigen::Index>(quantities.size()), without);
}

/// What is measured is what was new less the loss; of a section the loss itself.
double as_measured(MeasuredQuantity quantity, double lost, const LinerProfile& fresh) {
  switch (quantity) {
    case MeasuredQuantity::lifter_height:
      return lifter_height(fresh) - lost;
    case MeasuredQuantity::plate_thickness:
      return plate_thickness(fresh) - lost;
    case MeasuredQuantity::worn_section:
      return lost;
  }
  throw std::logic_error("a quantity of no kind");
}

/// What every shown value is compared with.
struct Comparison {
  const wear::WearPath& path;
  const std::vector<GaugeReading>& readings;
  const LinerProfile& fresh;
  Eigen::VectorXd factors;
  std::vector<std::optional<Eigen::VectorXd>> factors_without;
};

CalibratedReading compared(const ShownLoss& loss, const std::vector<ShownLoss>& all,
                           const Comparison& with) {
  const double hours = with.readings[loss.reading].operating_hours;
  const auto value = [&](double lost) { return as_measured(loss.quantity, lost, with.fresh); };
  const auto fitted = [&](const Eigen::VectorXd& factors) {
    return value(
        loss_of(wear::loss_at(with.path, factors, hours * seconds_per_hour), loss.quantity));
  };
  const auto line = [&](std::optional<std::size_t> without) {
    return value(hours *
                 lines(all, with.readings, without)[static_cast<Eigen::Index>(loss.quantity)]);
  };
  CalibratedReading row{hours,   loss.quantity, loss.use, value(loss.lost), loss.error,
                        unknown, unknown,       unknown,  unknown};
  if (loss.use == ReadingUse::beyond_campaign) return row;
  row.fitted = fitted(with.factors);
  row.line = line({});
  if (loss.use == ReadingUse::held_out) return row;
  row.line_without = line(loss.reading);
  if (loss.reading < with.factors_without.size() && with.factors_without[loss.reading])
    row.fitted_without = fitted(*with.factors_without[loss.reading]);
  return row;
}

std::vector<CalibrationRms> rms_of(const std::vector<CalibratedReading>& readings) {
  std::vector<CalibrationRms> result;
  for (const ReadingUse use : uses)
    for (const MeasuredQuantity quantity : quantities) {
      CalibrationRms sum{quantity, use, 0, 0.0, 0.0, 0.0, 0.0};
      for (const auto& row : readings) {
        if (row.use != use || row.quantity != quantity) continue;
        ++sum.readings;
        sum.fitted += std::pow(row.fitted - row.measured, 2);
        sum.line += std::pow(row.line - row.measured, 2);
        sum.fitted_without += std::pow(row.fitted_without - row.measured, 2);
        sum.line_without += std::pow(row.line_without - row.measured, 2);
      }
      for (double* value : {&sum.fitted, &sum.line, &sum.fitted_without, &sum.line_without})
        *value = std::sqrt(*value / sum.readings);
      if (sum.readings > 0) result.push_back(sum);
    }
  return result;
}

/// `other` with its coefficients times the factors; mechanisms at zero are left out.
Case with_factors(const Case& other, const Eigen::VectorXd& factors) {
  Case result = other;
  result.wear.mechanisms.clear();
  Eigen::Index number = 0;
  for (WearMechanism mechanism : other.wear.mechanisms) {
    const double factor = factors[number++];
    mechanism.specific_wear_rate *= factor;
    mechanism.depth_rate *= factor;
    if (factor > 0.0) result.wear.mechanisms.push_back(mechanism);
  }
  return result;
}

/// The largest share of a cycle's wear that falls elsewhere than by the campaign's law.
double largest_elsewhere(const std::vector<wear::PathCycle>& cycles,
                         const Eigen::VectorXd& factors) {
  double largest = 0.0;
  for (const auto& cycle : cycles) {
    Eigen::VectorXd rate = Eigen::VectorXd::Zero(cycle.campaign.values.size());
    for (std::size_t m = 0; m < cycle.mechanisms.size(); ++m)
      rate += factors[static_cast<Eigen::Index>(m)] * cycle.mechanisms[m].values;
    const Eigen::VectorXd widths =
        Eigen::VectorXd::Constant(rate.size(), cycle.campaign.bin_width());
    largest = std::fmax(largest, share_elsewhere(rate, cycle.campaign.values, widths));
  }
  return largest;
}

void check_some_fitted(const std::vector<wear::LossObservation>& observations,
                       const std::vector<ShownLoss>& shown, const wear::WearPath& path,
                       const LinerProfile& fresh, std::optional<double> until) {
  if (!observations.empty()) return;
  if (shown.empty())
    throw InputError(
        "no reading is later than hour 0, so there is no wear to fit; give readings of the worn "
        "liner");
  const bool all_beyond = std::all_of(shown.begin(), shown.end(), [](const auto& loss) {
    return loss.use == ReadingUse::beyond_campaign;
  });
  if (all_beyond)
    throw InputError(fmt::format(
        "every reading is more worn than the campaign's last liner (lifter {:.1f} mm high, {:.1f} "
        "cm2 worn off); let `millwear run` wear it further",
        1e3 * (lifter_height(fresh) - path.lost[path.channels.height()]),
        1e4 * path.lost.head(zones).sum()));
  throw InputError(
      fmt::format("no reading that the campaign's liners reach is as early as --until {:g} h; take "
                  "a later hour",
                  until.value_or(0.0)));
}

}  // namespace

CalibratedLaw calibrate(const Case& mill, const RunFolder& folder,
                        const std::vector<GaugeReading>& readings, std::optional<double> until) {
  const OpenCampaign kept = campaign_with_loads(folder);
  const Case& run = kept.campaign.mill;
  const Case other = with_law_of(as_kept(mill, folder), run, folder.root.string());
  const auto cycles = path_cycles(kept, other);
  const bool has_profile = std::any_of(readings.begin(), readings.end(), [&](const auto& reading) {
    return reading.profile && !(reading.operating_hours > until.value_or(reading.operating_hours));
  });
  const auto path = wear::wear_path(
      cycles, has_profile ? wear::PathPace::section : wear::PathPace::height, zones);
  std::vector<wear::LossObservation> observations;
  std::vector<ShownLoss> shown;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!(readings[i].operating_hours > 0.0)) continue;
    const ReadingUse use = use_of(path, readings[i], run.liner, until);
    if (use == ReadingUse::fitted) observe(readings[i], i, run.liner, observations);
    const auto losses = shown_losses(readings[i], i, use, run.liner);
    shown.insert(shown.end(), losses.begin(), losses.end());
  }
  check_some_fitted(observations, shown, path, run.liner, until);
  const wear::Calibration found = wear::calibrate(path, observations);
  const Eigen::VectorXd& factors = found.fit.factors;
  const Comparison comparison{path, readings, run.liner, factors,
                              wear::factors_without_each(path, observations, factors)};
  CalibratedLaw law{run,
                    other,
                    with_factors(other, factors),
                    found,
                    {},
                    {},
                    observations.back().channel < zones,
                    lifter_height(run.liner) - path.lost[path.channels.height()],
                    wear::time_of_path(path, factors) / seconds_per_hour,
                    largest_elsewhere(cycles, factors)};
  for (const auto& loss : shown) law.readings.push_back(compared(loss, shown, comparison));
  law.rms = rms_of(law.readings);
  return law;
}

}  // namespace millwear::orchestrator
