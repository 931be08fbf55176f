#include "orchestrator/study/study_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "liggghts_inputs/decks/carried_charge.h"
#include "mill/base/failure.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_edit.h"
#include "mill/case_file/case_file.h"
#include "mill/case_file/case_lock.h"
#include "mill/case_keys/case_schema.h"
#include "orchestrator/campaign/ledger.h"
#include "orchestrator/campaign/open_campaign.h"
#include "orchestrator/dem_run/cost_estimate.h"
#include "orchestrator/drawing/drawn_liner_reader.h"
#include "orchestrator/study/derived_axes.h"
#include "orchestrator/study/study_values.h"
#include "wear/numerics/random_stream.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

/// Of the results that the same case gives; a point of another version is run anew.
constexpr int result_version = 1;

constexpr std::size_t hash_digits = 8;

std::size_t product_of_sizes(const Study& study) {
  std::size_t count = 1;
  for (const StudyAxis& axis : study.axes) count *= axis.values.size();
  return count;
}

PointValues point_at(const Study& study, const std::vector<std::size_t>& indices) {
  PointValues point;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    point.values.push_back(study.axes[axis].values[indices[axis]]);
    point.labels.push_back(study.axes[axis].labels[indices[axis]]);
  }
  return point;
}

std::vector<PointValues> product(const Study& study) {
  std::vector<PointValues> points;
  for (std::size_t i = 0; i < product_of_sizes(study); ++i) {
    std::vector<std::size_t> indices(study.axes.size());
    std::size_t rest = i;
    for (std::size_t axis = study.axes.size(); axis-- > 0;) {
      indices[axis] = rest % study.axes[axis].values.size();
      rest /= study.axes[axis].values.size();
    }
    points.push_back(point_at(study, indices));
  }
  return points;
}

std::vector<PointValues> side_by_side(const Study& study) {
  std::vector<PointValues> points;
  for (std::size_t i = 0; i < study.axes.front().values.size(); ++i)
    points.push_back(point_at(study, std::vector<std::size_t>(study.axes.size(), i)));
  return points;
}

double uniform(std::uint64_t seed, std::uint64_t place) {
  return static_cast<double>(wear::random_bits(seed, place) >> 11) * 0x1.0p-53;
}

/// The numbers 0 ... count - 1 in an order of chance (Fisher and Yates).
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(numbers[i - 1],
              numbers[static_cast<std::size_t>(uniform(seed, i) * static_cast<double>(i))]);
  return numbers;
}

std::vector<PointValues> latin_hypercube(const Study& study) {
  const auto count = static_cast<std::size_t>(study.samples);
  std::vector<PointValues> points(count);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    const StudyAxis& axis = study.axes[i];
    const std::uint64_t stream = wear::random_bits(study.seed, i);
    const auto parts = shuffled(count, stream);
    for (std::size_t point = 0; point < count; ++point) {
      const double share =
          (static_cast<double>(parts[point]) + uniform(stream, count + 1 + point)) /
          static_cast<double>(count);
      const double number = std::lerp(axis.low, axis.high, share);
      CaseValue value{axis.line, number};
      if (is_whole_axis(axis.key)) value.data = std::int64_t{std::llround(number)};
      points[point].labels.push_back(label_of(value));
      points[point].values.push_back(std::move(value));
    }
  }
  return points;
}

/// Keys of which a case gives one, so that a value of one takes the other's place.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> either{
    {{"speed_rpm", "critical_speed_fraction"}, {"critical_speed_fraction", "speed_rpm"}}};

CaseDocument with_axis(const CaseDocument& document, const std::string& key,
                       const CaseValue& value) {
  const CaseKeyPath path = case_key_path(key);
  CaseDocument edited = document;
  for (const auto& [given, other] : either)
    if (path.table == "mill" && path.key == given)
      edited = without_key(std::move(edited), "mill", other);
  return with_value(std::move(edited), path, value);
}

std::string spoken_values(const Study& study, const PointValues& point) {
  std::string text;
  for (std::size_t i = 0; i < study.axes.size(); ++i)
    text += fmt::format("{}{} = {}", i > 0 ? ", " : "", study.axes[i].key, point.labels[i]);
  return text;
}

/// What a case says of a value, as a problem of the study's line.
[[noreturn]] void refuse(const Study& study, int line, const std::string& what,
                         const std::string& why) {
  throw InputError(fmt::format("{}:{}: the case refuses {}: {}", study.file.string(), line, what,
                               why.substr(0, why.find('\n'))));
}

/// Where the campaigns of a study find the charge of its base case, from their own folders.
constexpr const char* base_charge = "../../charge";

/// With the charge that it begins with. Throws InputError where the base case's cannot be its.
void take_charge(const Study& study, const Case& base, Case& mill) {
  if (study.charge_from_base) {
    liggghts::check_same_charge(mill, base);
    mill.dem.charge_from = base_charge;
    mill.dem.mix_until_steady = mill.dem.contact_path == ContactPath::recorder;
  } else if (mill.dem.charge_from) {
    mill.dem.charge_from = folder_of_charge(mill);
  }
}

}  // namespace

bool is_whole_axis(const std::string& key) {
  if (is_derived_axis(key)) return false;
  const CaseKeyPath path = case_key_path(key);
  return find_key(path.table, path.key)->type == KeyType::integer;
}

std::size_t point_count(const Study& study) {
  switch (study.combine) {
    case Combine::product:
      return product_of_sizes(study);
    case Combine::latin_hypercube:
    case Combine::search:
      return static_cast<std::size_t>(study.samples);
    case Combine::zip:
    case Combine::table:
      return study.axes.front().values.size();
  }
  throw std::logic_error("a combination of no kind");
}

std::vector<PointValues> point_values(const Study& study) {
  switch (study.combine) {
    case Combine::product:
      return product(study);
    case Combine::latin_hypercube:
      return latin_hypercube(study);
    case Combine::search:
      throw std::logic_error("a search has its points one after the other");
    case Combine::zip:
    case Combine::table:
      return side_by_side(study);
  }
  throw std::logic_error("a combination of no kind");
}

CaseDocument document_of_point(const Study& study, const CaseDocument& base,
                               const PointValues& point) {
  CaseDocument document = base;
  const bool has_rows = std::ranges::any_of(
      study.axes, [](const StudyAxis& axis) { return axis.key == "mill.rows"; });
  for (const bool is_derived : {false, true})
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
      const StudyAxis& axis = study.axes[i];
      if (is_derived_axis(axis.key) != is_derived) continue;
      try {
        document = is_derived ? with_derived(document, axis.key, point.values[i],
                                             has_rows ? DerivedChoice::height : DerivedChoice::rows)
                              : with_axis(document, axis.key, point.values[i]);
      } catch (const InputError& problem) {
        refuse(study, point.values[i].line, fmt::format("{} = {}", axis.key, point.labels[i]),
               problem.what());
      }
    }
  return document;
}

StudyPlan plan_of(const Study& study) {
  const CaseDocument base = read_case_document(study.case_file);
  StudyPlan plan{study, case_from_document(base, read_drawn_liner), point_values(study), {}};
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    const PointValues& point = plan.points[i];
    const CaseDocument document = document_of_point(study, base, point);
    Case mill;
    try {
      mill = case_from_document(document, read_drawn_liner);
      take_charge(study, plan.base, mill);
    } catch (const InputError& problem) {
      refuse(study, point.values.empty() ? 1 : point.values.front().line,
             spoken_values(study, point), problem.what());
    }
    const std::uint64_t first_seed = mill.dem.seed;
    const CostEstimate cost = estimate_cost(mill, 1);
    for (int replicate = 0; replicate < study.replicates; ++replicate) {
      mill.dem.seed = study.seeds.empty() ? first_seed + static_cast<std::uint64_t>(replicate)
                                          : study.seeds[static_cast<std::size_t>(replicate)];
      const std::string text = locked_case_text(mill);
      plan.campaigns.push_back(
          {i, mill.dem.seed, text,
           hash_of_text(fmt::format("{}\n{}", result_version, text)).substr(0, hash_digits),
           totals(mill).particles, plan_steps(mill).time_step, campaign_seconds(mill, cost),
           cost.longest_chunk});
    }
  }
  return plan;
}

}  // namespace millwear::orchestrator
