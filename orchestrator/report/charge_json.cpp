#include "orchestrator/report/charge_json.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

#include "mill/base/number_or_null.h"
#include "orchestrator/report/base64.h"
#include "orchestrator/report/deflate.h"
#include "orchestrator/report/page_frames.h"
#include "wear/record/charge_motion.h"

namespace millwear::orchestrator {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t every_frame = 2;
constexpr double outermost_share = 0.002;  // of the values, beyond the scale's ends

/// Numbers as zlib packs their bytes, as text.
template <class Integer>
std::string packed(const std::vector<Integer>& values) {
  static_assert(std::endian::native == std::endian::little);
  return base64(deflated(
      {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(Integer)}));
}

enum class Steps { equal, equal_ratios };

/// What the 255 values of a map stand for, the same in all cycles.
struct Scale {
  double low;
  double high;
  Steps steps = Steps::equal;

  /// Where a value lies from low to high, 0 ... 1.
  [[nodiscard]] double share(double value) const {
    const double share = steps == Steps::equal ? (value - low) / (high - low)
                                               : std::log(value / low) / std::log(high / low);
    return std::clamp(share, 0.0, 1.0);
  }
  [[nodiscard]] bool has(double value) const {
    return std::isfinite(value) && (steps == Steps::equal || value >= low);
  }
};

/// From the smallest to the largest of the values but for a few of the outermost. All but
/// velocities and sizes begin at zero: powers below are elastic energy on its way.
Scale scale_of(std::vector<double> values, const std::string& unit) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {0.0, 1.0};
  const auto at = [&](double share) {
    const auto rank = values.begin() +
                      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, rank);
    return *rank;
  };
  const bool begins_at_zero = unit != "m/s" && unit != "m";
  const Scale scale{begins_at_zero ? 0.0 : at(outermost_share), at(1.0 - outermost_share)};
  return scale.high > scale.low ? scale : Scale{scale.low, scale.low + 1.0};
}

Json json_of_map(const double* values, std::size_t count, const Scale& scale,
                 const std::string& unit) {
  std::vector<std::uint8_t> steps(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    if (scale.has(values[i]))
      steps[i] = static_cast<std::uint8_t>(1.0 + std::round(254.0 * scale.share(values[i])));
  return {{"low", scale.low},
          {"high", scale.high},
          {"log", scale.steps == Steps::equal_ratios},
          {"unit", unit},
          {"values", packed(steps)}};
}

using Scales = std::map<std::string, Scale>;

Scales map_scales(const std::vector<ChargeOfCycle>& cycles) {
  std::map<std::string, std::vector<double>> values;
  std::map<std::string, std::string> units;
  for (const ChargeOfCycle& charge : cycles)
    for (const SectionMap& map : charge.maps) {
      auto& all = values[map.name];
      all.insert(all.end(), map.values.begin(), map.values.end());
      units[map.name] = map.unit;
    }
  Scales scales;
  for (auto& [name, all] : values) scales[name] = scale_of(std::move(all), units.at(name));
  return scales;
}

Json json_of(const Eigen::Vector2d& place) {
  return {number_or_null(place.x()), number_or_null(place.y())};
}

Json json_of(const wear::ChargeLandmarks& landmarks) {
  return {{"shoulder", number_or_null(landmarks.shoulder)},
          {"bulk_toe", number_or_null(landmarks.bulk_toe)},
          {"head", json_of(landmarks.head)},
          {"centre", json_of(landmarks.centre)}};
}

Json json_of(const wear::ChargeFrames& frames, std::size_t most_bytes) {
  const PageFrames page = page_frames(frames, every_frame, most_bytes);
  return {{"particles", page.classes.size()},
          {"thinning", page.thinning},
          {"times", page.times},
          {"mill_angles", page.mill_angles},
          {"across", {frames.across.low, frames.across.high}},
          {"along", {frames.along.low, frames.along.high}},
          {"step", page.step},
          {"classes", packed(page.classes)},
          {"first", packed(page.first)},
          {"changes", packed(page.changes)}};
}

/// A polar load over its mean, a column a bin, angles from six o'clock on.
Eigen::MatrixXd over_mean(const Eigen::MatrixXd& load) {
  const Eigen::Index half = wear::polar_columns / 2;
  Eigen::MatrixXd turned(load.rows(), wear::polar_columns);
  turned << load.rightCols(half), load.leftCols(half);
  const double mean = load.mean();
  return turned.transpose() / (mean > 0.0 ? mean : 1.0);
}

/// Hits are few and heavy: in equal steps all but some cells would look empty.
Scale polar_scale(const std::vector<PolarLoadOfCycle>& loads, std::size_t measure) {
  constexpr double least_shown = 0.1;
  double most = 1.0;
  for (const auto& load : loads)
    most = std::max(most, over_mean(load.load.values[measure]).maxCoeff());
  return {least_shown, most, Steps::equal_ratios};
}

Json json_of(const wear::PolarLoad& load, const std::vector<Scale>& scales) {
  Json maps = Json::object();
  for (std::size_t m = 0; m < wear::polar_measures.size(); ++m) {
    const auto measure = wear::polar_measures[m];
    const Eigen::MatrixXd shown = over_mean(load.values[m]);
    maps[measure == Measure::samples ? "contacts" : std::string(measure_names[index_of(measure)])] =
        json_of_map(shown.data(), static_cast<std::size_t>(shown.size()), scales[m],
                    "times the mean");
  }
  return {{"angles", wear::polar_columns}, {"maps", maps}};
}

std::vector<Scale> polar_scales(const std::vector<PolarLoadOfCycle>& loads) {
  std::vector<Scale> scales;
  for (std::size_t m = 0; m < wear::polar_measures.size(); ++m)
    scales.push_back(polar_scale(loads, m));
  return scales;
}

}  // namespace

std::string charge_json(const CampaignResults& data, std::size_t most_frame_bytes) {
  const Scales scales = map_scales(data.charge.cycles);
  const std::vector<Scale> around = polar_scales(data.polar);
  Json cycles = Json::array();
  for (const ChargeOfCycle& charge : data.charge.cycles) {
    Json maps = Json::object();
    for (const SectionMap& map : charge.maps)
      maps[map.name] = json_of_map(map.values.data(), static_cast<std::size_t>(map.values.size()),
                                   scales.at(map.name), map.unit);
    const auto polar = std::ranges::find(data.polar, charge.cycle, &PolarLoadOfCycle::cycle);
    Json pictures = Json::object();
    for (const auto& [name, jpeg] : charge.pictures)
      pictures[name] = "data:image/jpeg;base64," +
                       base64({reinterpret_cast<const std::uint8_t*>(jpeg.data()), jpeg.size()});
    Json liner = Json::array();
    for (const auto& node : charge.liner.nodes) liner.push_back(json_of(node));
    cycles.push_back(
        {{"cycle", charge.cycle},
         {"speed", charge.speed},
         {"liner", liner},
         {"section", {{"half_width", charge.grid.half_width}, {"cells", charge.grid.cells}}},
         {"maps", maps},
         {"landmarks", json_of(charge.landmarks)},
         {"around", polar == data.polar.end() ? Json(nullptr) : json_of(polar->load, around)},
         {"frames", charge.frames ? json_of(*charge.frames, most_frame_bytes) : Json(nullptr)},
         {"pictures", pictures}});
  }
  Json classes = Json::array();
  for (const ShownClass& one : data.charge.classes)
    classes.push_back({{"name", one.name},
                       {"material", one.material},
                       {"diameter", one.diameter},
                       {"density", one.density}});
  return Json{{"classes", classes},
              {"locked_slip", wear::locked_slip},
              {"slice_length", data.charge.slice_length},
              {"fastest", data.charge.fastest},
              {"cycles", cycles}}
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace millwear::orchestrator
