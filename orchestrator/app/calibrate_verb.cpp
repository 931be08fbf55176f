#include "orchestrator/app/calibrate_verb.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mill/base/constants.h"
#include "mill/base/number_or_null.h"
#include "mill/base/published_file.h"
#include "mill/case/case_units.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/calibration/calibrated_law.h"
#include "orchestrator/calibration/calibration_text.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/gauge/gauge_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Half the 95 % interval of a normal error, in standard errors.
/// Above this share of wear elsewhere, the campaign's shapes are not those of the law found.
constexpr double elsewhere_of_doubt = 0.05;

struct Coefficient {
  const char* key;
  double value;
  double error;
  double low;
  double high;
};

Coefficient coefficient_of(const CalibratedLaw& law, std::size_t number) {
  const WearMechanism& mechanism = law.other.wear.mechanisms[number];
  const auto m = static_cast<Eigen::Index>(number);
  const bool corrodes = mechanism.law == WearLaw::corrosion;
  const double unit = corrodes ? mechanism.depth_rate / depth_rate_from_m_per_year(1.0)
                               : mechanism.specific_wear_rate;
  const double factor = law.found.fit.factors[m];
  const double half = errors_of_95_percent * law.found.errors[m];
  return {corrodes ? "depth_rate_m_per_year" : "specific_wear_rate_per_pa", unit * factor,
          unit * law.found.errors[m], unit * std::fmax(0.0, factor - half), unit * (factor + half)};
}

nlohmann::json mechanisms_json(const CalibratedLaw& law) {
  nlohmann::json mechanisms = nlohmann::json::array();
  for (std::size_t i = 0; i < law.other.wear.mechanisms.size(); ++i) {
    const Coefficient found = coefficient_of(law, i);
    const auto m = static_cast<Eigen::Index>(i);
    mechanisms.push_back({{"law", name_of(law.other.wear.mechanisms[i].law)},
                          {"key", found.key},
                          {"value", found.value},
                          {"standard_error", number_or_null(found.error)},
                          {"interval_95", {number_or_null(found.low), number_or_null(found.high)}},
                          {"factor", law.found.fit.factors[m]},
                          {"chi_square_rise_without", number_or_null(law.found.rise_without[m])}});
  }
  return mechanisms;
}

nlohmann::json alike_json(const CalibratedLaw& law) {
  nlohmann::json alike = nlohmann::json::array();
  for (const auto& pair : law.found.alike)
    alike.push_back({{"mechanisms", {pair.first, pair.second}},
                     {"correlation", number_or_null(pair.correlation)},
                     {"exchangeable", pair.exchangeable},
                     {"lost_together", number_or_null(pair.lost)},
                     {"standard_error", number_or_null(pair.error)},
                     {"unit", law.by_section ? "m2" : "m"}});
  return alike;
}

nlohmann::json json_of(const CalibratedLaw& law) {
  nlohmann::json readings = nlohmann::json::array();
  for (const auto& row : law.readings)
    readings.push_back({{"operating_hours", row.hours},
                        {"quantity", name_of(row.quantity)},
                        {"use", name_of(row.use)},
                        {"measured", row.measured},
                        {"error", row.error},
                        {"fitted", number_or_null(row.fitted)},
                        {"line", number_or_null(row.line)},
                        {"fitted_without", number_or_null(row.fitted_without)},
                        {"line_without", number_or_null(row.line_without)}});
  nlohmann::json rms = nlohmann::json::array();
  for (const auto& sum : law.rms)
    rms.push_back({{"quantity", name_of(sum.quantity)},
                   {"use", name_of(sum.use)},
                   {"readings", sum.readings},
                   {"fitted", number_or_null(sum.fitted)},
                   {"line", number_or_null(sum.line)},
                   {"fitted_without", number_or_null(sum.fitted_without)},
                   {"line_without", number_or_null(sum.line_without)}});
  return {
      {"mechanisms", mechanisms_json(law)},
      {"alike", alike_json(law)},
      {"chi_square", law.found.fit.chi_square},
      {"degrees_of_freedom", law.found.freedom},
      {"error_scale", law.found.error_scale},
      {"condition_number", number_or_null(law.found.condition)},
      {"readings", readings},
      {"rms", rms},
      {"last_liner",
       {{"lifter_height_m", law.lifter_height}, {"operating_hours", number_or_null(law.hours)}}},
      {"elsewhere", number_or_null(law.elsewhere)},
      {"wear_toml", wear_table(law)}};
}

/// Without the only mechanism there is no fit.
std::string rise_cell(double rise) {
  return std::isfinite(rise) ? fmt::format("{:.1f}", rise) : "-";
}

void print_coefficients(const CalibratedLaw& law) {
  fmt::print("Campaign  {}\n\n", spoken(law.campaign.wear.mechanisms, law.campaign.materials));
  fmt::print("mechanism                      coefficient  std error        95 % interval   rise\n");
  for (std::size_t i = 0; i < law.other.wear.mechanisms.size(); ++i) {
    const Coefficient found = coefficient_of(law, i);
    fmt::print("{} {:<18} {:>19.4g} {:>10.2g} {:>10.3g} {:>10.3g} {:>6}  {}\n", i + 1,
               name_of(law.other.wear.mechanisms[i].law), found.value, found.error, found.low,
               found.high, rise_cell(law.found.rise_without[static_cast<Eigen::Index>(i)]),
               found.key);
  }
  fmt::print("chi-square {:.1f} of {} degrees of freedom", law.found.fit.chi_square,
             law.found.freedom);
  if (law.found.error_scale > 1.0)
    fmt::print("; all errors hold its root, {:.2f}", law.found.error_scale);
  fmt::print(" (rise: of chi-square without the mechanism; below {:g} it may go)\n",
             wear::rise_of_doubt * law.found.error_scale * law.found.error_scale);
}

void print_alike(const CalibratedLaw& law) {
  const double unit = law.by_section ? 1e4 : 1e3;
  for (const auto& pair : law.found.alike) {
    fmt::print(
        "\nMechanisms {} and {} {}", pair.first + 1, pair.second + 1,
        pair.exchangeable ? "cannot be told apart by these readings" : "are hard to tell apart");
    if (std::isfinite(pair.correlation)) fmt::print(" (correlation {:.3f})", pair.correlation);
    fmt::print(": known is what both took by the last reading,\n{:.4g} +- {:.2g} {}.\n",
               unit * pair.lost, unit * pair.error, law.by_section ? "cm2" : "mm");
  }
}

double in_unit(MeasuredQuantity quantity, double value) {
  return value * (quantity == MeasuredQuantity::worn_section ? 1e4 : 1e3);
}

std::string spoken(MeasuredQuantity quantity) {
  switch (quantity) {
    case MeasuredQuantity::lifter_height:
      return "height, mm";
    case MeasuredQuantity::plate_thickness:
      return "plate, mm";
    case MeasuredQuantity::worn_section:
      return "worn off, cm2";
  }
  throw std::logic_error("a quantity of no kind");
}

std::string spoken(ReadingUse use) {
  switch (use) {
    case ReadingUse::fitted:
      return "";
    case ReadingUse::shown:
      return "beside the profile, not fitted";
    case ReadingUse::held_out:
      return "held out";
    case ReadingUse::beyond_campaign:
      return "more worn than the campaign's last liner: left out";
  }
  throw std::logic_error("a use of no kind");
}

std::string cell(MeasuredQuantity quantity, double value) {
  return std::isfinite(value) ? fmt::format("{:9.2f}", in_unit(quantity, value))
                              : fmt::format("{:>9}", "-");
}

void print_readings(const CalibratedLaw& law) {
  fmt::print("\n                                                       left out:\n");
  fmt::print("   hours  quantity        measured   fitted      line   fitted      line\n");
  for (const auto& row : law.readings)
    fmt::print("{:8.0f}  {:<13} {} {} {} {} {}  {}\n", row.hours, spoken(row.quantity),
               cell(row.quantity, row.measured), cell(row.quantity, row.fitted),
               cell(row.quantity, row.line), cell(row.quantity, row.fitted_without),
               cell(row.quantity, row.line_without), spoken(row.use));
  fmt::print("root mean square of the differences:\n");
  for (const auto& sum : law.rms)
    fmt::print("{:8}  {:<13}           {} {} {} {}  {}\n", sum.readings, spoken(sum.quantity),
               cell(sum.quantity, sum.fitted), cell(sum.quantity, sum.line),
               cell(sum.quantity, sum.fitted_without), cell(sum.quantity, sum.line_without),
               spoken(sum.use));
}

void print_text(const CalibratedLaw& law) {
  print_coefficients(law);
  print_alike(law);
  print_readings(law);
  fmt::print("\nThe campaign's last liner (lifter {:.1f} mm high) comes after {:.0f} h.\n",
             1e3 * law.lifter_height, law.hours);
  if (law.elsewhere > elsewhere_of_doubt)
    fmt::print(
        "Up to {:.1f} % of the wear falls elsewhere than in the campaign, whose shapes and loads\n"
        "these are: `millwear run` the case with these coefficients, and calibrate along it "
        "again.\n",
        100.0 * law.elsewhere);
  fmt::print("\nFor the case file:\n\n{}", wear_table(law));
}

}  // namespace

void add_options(CLI::App& verb, CalibrateOptions& options) {
  add_options(verb, options.common);
  add_campaign_folder(verb, options.out);
  add_readings_folder(verb, options.readings);
  verb.add_option("--until", options.until,
                  "Fit to the readings up to these operating hours and predict the later ones")
      ->check(CLI::PositiveNumber);
  add_csv(verb, options.csv, "Write the readings beside what is fitted");
}

void calibrate_verb(const CalibrateOptions& options) {
  const Case mill = read_case(options.common.case_file, read_drawn_liner);
  const RunFolder folder = run_folder_of(mill, options.out);
  if (options.csv) check_output_file("--csv", *options.csv, {options.common.case_file});
  const auto readings = needed_readings_in(gauge_folder(mill, options.readings), mill);
  const CalibratedLaw law = calibrate(mill, folder, readings, options.until);
  if (options.csv) publish(*options.csv, calibration_csv(law));
  if (options.common.form == OutputForm::json)
    fmt::print("{}\n", json_of(law).dump(1));
  else
    print_text(law);
}

}  // namespace millwear::orchestrator
