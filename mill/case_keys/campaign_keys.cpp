#include "mill/case_keys/campaign_keys.h"

#include <cmath>

#include "mill/case/case_units.h"

namespace millwear {
namespace {

using key::choice;
using key::defaulted;
using key::in;
using key::left_to_builder;
using key::locked_unless_default;
using key::optional;
using key::required;

key::Place<CampaignSettings, std::vector<double>> reversal_times() {
  return {[](CampaignSettings& campaign, std::vector<double> times) {
            campaign.reversal_times = std::move(times);
          },
          [](const CampaignSettings& campaign) {
            return campaign.reversal_times.empty() ? std::nullopt
                                                   : std::optional(campaign.reversal_times);
          }};
}

key::Place<OperatingChange, std::vector<double>> particle_counts() {
  return {[](OperatingChange& change, const std::vector<double>& counts) {
            change.counts.clear();
            for (const double count : counts)
              change.counts.push_back(static_cast<std::size_t>(std::llround(count)));
          },
          [](const OperatingChange& change) {
            return change.counts.empty() ? std::nullopt
                                         : std::optional(std::vector<double>(change.counts.begin(),
                                                                             change.counts.end()));
          }};
}

}  // namespace

const std::vector<KeyRow<CampaignSettings>>& campaign_keys() {
  using Campaign = CampaignSettings;
  static const auto rows = rows_of<Campaign>(
      "campaign",
      {choice(Presence::defaulted, "scheme", in(&Campaign::scheme),
              {Scheme::threshold, Scheme::adaptive},
              "how the next DEM is timed: after a worn `threshold` (the 2006 paper), or by the "
              "error of the last step"),
       defaulted("threshold", in(&Campaign::threshold), above_up_to(0.0, 1.0),
                 "worn share of the new lifter's volume per DEM load (with `threshold`) [-]"),
       defaulted("step_tolerance", in(&Campaign::step_tolerance), above_up_to(0.0, 0.5),
                 "share of the new lifter's volume that one DEM load may wear at the wrong place "
                 "(with `adaptive`) [-]"),
       defaulted("largest_share", in(&Campaign::largest_share), above_up_to(0.0, 10.0),
                 "share of the new lifter's volume that one DEM load may wear at all (with "
                 "`adaptive`) [-]"),
       defaulted("steps_per_cycle", in(&Campaign::steps_per_cycle), between(1, 1000),
                 "geometry steps on one DEM load"),
       required("height_limit_m", in(&Campaign::height_limit), at_least(-10.0),
                "the liner is worn out at this lifter height, from where the plate was when new: "
                "below 0 the crest stands lower than the new plate did [m]"),
       optional("plate_limit_m", in(&Campaign::plate_limit), at_least(0.0),
                "... or at this least plate thickness; a tenth of `plate_thickness_m` where "
                "missing [m]"),
       defaulted("cycle_limit", in(&Campaign::cycle_limit), between(1, 10000),
                 "the campaign stops after so many cycles"),
       optional("target_life_error", in(&Campaign::target_life_error), above_up_to(0.0, 1.0),
                "loads are measured for longer than `measure_revolutions`, up to four times, as "
                "far as the life's 95 % band asks for it to become no wider than this share of "
                "the life on either side [-]"),
       optional("reversal_hours", converted(time_from_hours, reversal_times()), positive,
                "operating hours at which the mill is made to turn the other way, increasing; "
                "never where missing [h]"),
       left_to_builder<Campaign>(
           Presence::optional, KeyType::file, "operation_csv", any_value,
           "changes of operation as a table, in place of [[campaign.operation]]; path from this "
           "file's folder ([how_to_follow_an_operating_history.md]"
           "(how_to_follow_an_operating_history.md))")});
  return rows;
}

const std::vector<KeyRow<OperatingChange>>& operation_keys() {
  using Change = OperatingChange;
  static const auto rows = rows_of<Change>(
      "campaign.operation",
      {optional("from_hours", converted(time_from_hours, in(&Change::from_time)), at_least(0.0),
                "operating hours at which the change begins; this or `from_lifter_height_m` [h]"),
       left_to_builder<Change>(Presence::optional, KeyType::real, "to_hours", positive,
                               "operating hours at which the next change begins; only checked, so "
                               "that no period is missing or given twice [h]"),
       optional("from_lifter_height_m", in(&Change::from_height), positive,
                "the change begins once the lifter is worn to this height [m]"),
       optional("speed_rpm", converted(speed_from_rpm, in(&Change::speed)), positive,
                "speed [1/min]"),
       left_to_builder<Change>(Presence::optional, KeyType::real, "critical_speed_fraction",
                               above_up_to(0.0, 3.0),
                               "the same as a share of the critical speed [-]"),
       left_to_builder<Change>(Presence::optional, KeyType::real, "total_filling",
                               above_up_to(0.0, 0.9),
                               "as in [charge]; only where that gives `total_filling` [-]"),
       left_to_builder<Change>(Presence::optional, KeyType::real, "ball_filling",
                               above_up_to(0.0, 0.9), "as in [charge], likewise [-]"),
       optional("counts", particle_counts(), at_least(1.0),
                "particles of each class of the charge, largest first, as `millwear check` lists "
                "them; where the charge is given by counts"),
       optional("feed_rate_t_per_h", converted(feed_from_t_per_h, in(&Change::feed_rate)), positive,
                "fresh feed [t/h]"),
       choice(Presence::optional, "direction", in(&Change::rotation),
              {Rotation::as_new, Rotation::reversed},
              "direction of rotation: as when the liner was new, or reversed"),
       locked_unless_default(defaulted(
           "idle_hours", converted(time_from_hours, in(&Change::idle_time)), at_least(0.0),
           "the mill stands still for so long before it goes on; the calendar runs on, the "
           "operating hours do not [h]"))});
  return rows;
}

const std::vector<KeyRow<GaugeSettings>>& gauge_keys() {
  static const auto rows = rows_of<GaugeSettings>(
      "gauge",
      {optional("calibrate_until_hours", in(&GaugeSettings::calibrate_until), positive,
                "`compare` and the report calibrate the campaign's hours on the heights read up to "
                "these operating hours and predict the later ones; not at all where missing [h]")});
  return rows;
}

}  // namespace millwear
