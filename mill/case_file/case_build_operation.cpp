#include "mill/case_file/case_build_operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mill/case/case_units.h"
#include "mill/case/operated_mill.h"
#include "mill/case_file/case_build_charge.h"
#include "mill/case_file/case_checks.h"
#include "mill/case_file/case_edit.h"
#include "mill/case_file/case_schema_check.h"
#include "mill/case_file/case_values.h"
#include "mill/case_file/operation_csv.h"
#include "mill/case_keys/campaign_keys.h"
#include "mill/liner/profile_measures.h"

namespace millwear {
namespace {

/// Changes nearer in time than this are the same time [h].
constexpr double same_hours = 1e-6;

void check_trigger(const CaseTable& table, const Case& mill, CaseProblems& problems) {
  const auto hours = optional_real(table, "from_hours");
  const auto height = optional_real(table, "from_lifter_height_m");
  if (hours.has_value() == height.has_value()) {
    problems.add(table.line,
                 fmt::format("the change has {} `from_hours` {} `from_lifter_height_m`; give one "
                             "of the two",
                             hours ? "both" : "neither", hours ? "and" : "nor"));
    return;
  }
  if (!height) return;
  const double fresh = lifter_height(mill.liner);
  if (*height >= fresh || *height <= mill.campaign.height_limit)
    problems.add(table.line,
                 fmt::format("no lifter is worn to {:g} m (new it is {:.4g} m high, and worn out "
                             "at {:g} m); give a height between the two",
                             *height, fresh, mill.campaign.height_limit));
}

/// Of two changes that follow each other.
void check_order(const CaseTable& before, const CaseTable& after, CaseProblems& problems) {
  const auto first = optional_real(before, "from_hours");
  const auto second = optional_real(after, "from_hours");
  if (first && second && *second <= *first + same_hours)
    problems.add(after.line, fmt::format("time runs backwards ({:g} h stands after {:g} h); list "
                                         "each change once, in the order of time",
                                         *second, *first));
  const auto high = optional_real(before, "from_lifter_height_m");
  const auto low = optional_real(after, "from_lifter_height_m");
  if (high && low && *low >= *high)
    problems.add(after.line, fmt::format("the lifter grows ({:g} m stands after {:g} m); list each "
                                         "change once, the higher lifter first",
                                         *low, *high));
  const auto until = optional_real(before, "to_hours");
  if (!until || !second || *second <= *first) return;
  if (*second > *until + same_hours)
    problems.add(after.line,
                 fmt::format("nothing is said of {:g} to {:g} h; let the period before end where "
                             "this begins, and give the time that the mill stood as idle time",
                             *until, *second));
  if (*second < *until - same_hours)
    problems.add(after.line, fmt::format("{:g} to {:g} h are given twice; let the period before "
                                         "end where this begins",
                                         *second, *until));
}

void check_periods(const std::vector<const CaseTable*>& tables, CaseProblems& problems) {
  for (const CaseTable* table : tables) {
    const auto from = optional_real(*table, "from_hours");
    const auto until = optional_real(*table, "to_hours");
    if (until && (!from || *until <= *from))
      problems.add(table->find("to_hours")->line,
                   fmt::format("the period ends at {:g} h, {}", *until,
                               from ? fmt::format("and begins at {:g} h; mend one", *from)
                                    : "and has no `from_hours`; add it, or delete `to_hours`"));
  }
  for (std::size_t i = 1; i < tables.size(); ++i) check_order(*tables[i - 1], *tables[i], problems);
}

void read_speed(const CaseTable& table, const Case& mill, OperatingChange& change,
                CaseProblems& problems) {
  const auto fraction = optional_real(table, "critical_speed_fraction");
  if (!fraction) return;
  if (change.speed)
    problems.add(table.find("critical_speed_fraction")->line,
                 "both `speed_rpm` and `critical_speed_fraction` give the speed; delete one");
  const double speed = *fraction * critical_speed(mill.liner.sector, largest_diameter(mill));
  change.speed = speed_from_rpm(speed / speed_from_rpm(1.0));
}

/// The fillings in force, as [charge] or the last change gave them.
struct Fillings {
  std::optional<double> total;
  std::optional<double> balls;
};

/// The charge of the document with other fillings.
Charge charge_with(const CaseDocument& document, const Fillings& fillings, const Case& mill,
                   int line) {
  CaseDocument edited = document;
  const auto put = [&](std::string_view key, std::optional<double> value) {
    if (value)
      edited = with_value(std::move(edited), {"charge", "", std::string(key)}, {line, *value});
  };
  put("total_filling", fillings.total);
  put("ball_filling", fillings.balls);
  CaseProblems problems(document.file);
  Charge charge =
      build_charge(edited, mill.materials, mill.liner.sector, mill.slice_length, problems);
  problems.throw_if_any();
  return charge;
}

bool has_same_classes(const Charge& one, const Charge& other) {
  return std::ranges::equal(one.classes, other.classes,
                            [](const ParticleClass& a, const ParticleClass& b) {
                              return a.material == b.material && a.diameter == b.diameter;
                            });
}

void read_fillings(const CaseTable& table, const CaseDocument& document, const Case& mill,
                   Fillings& fillings, OperatingChange& change, CaseProblems& problems) {
  const auto total = optional_real(table, "total_filling");
  const auto balls = optional_real(table, "ball_filling");
  if (!total && !balls) return;
  if (!change.counts.empty() || !fillings.total || (balls && !fillings.balls)) {
    problems.add(table.line,
                 !change.counts.empty() ? "both `counts` and fillings give the charge; delete one"
                 : !fillings.total
                     ? "[charge] gives counts and no `total_filling`, so a change gives `counts`"
                     : "[charge] has no `ball_filling` that could change; delete it here");
    return;
  }
  if (total) fillings.total = total;
  if (balls) fillings.balls = balls;
  problems.attempt(table.line, [&] {
    const Charge charge = charge_with(document, fillings, mill, table.line);
    if (!has_same_classes(charge, mill.charge))
      throw InputError(
          "a class of the charge is left without a particle; raise the filling, or lengthen the "
          "slice");
    for (const ParticleClass& kind : charge.classes) change.counts.push_back(kind.count);
  });
}

void check_counts(const CaseTable& table, const Case& mill, const OperatingChange& change,
                  CaseProblems& problems) {
  const CaseValue* const value = table.find("counts");
  if (value == nullptr) return;
  if (change.counts.size() != mill.charge.classes.size())
    problems.add(value->line, fmt::format("{} counts for the {} classes of the charge ({}); give "
                                          "one a class",
                                          change.counts.size(), mill.charge.classes.size(),
                                          spoken_classes(mill)));
  if (std::ranges::any_of(numbers_in(*value), [](double n) { return n != std::floor(n); }))
    problems.add(value->line, "a count is no whole number; mend it");
}

void check_change(const CaseTable& table, const OperatingChange& change, const Case& mill,
                  CaseProblems& problems) {
  if (!asks_for_load(change) && !change.feed_rate && change.idle_time == 0.0)
    problems.add(table.line,
                 "the change changes nothing; give a speed, a filling, a feed rate, a direction or "
                 "an idle time, or delete it");
  if (change.rotation && !mill.campaign.reversal_times.empty())
    problems.add(table.find("direction")->line,
                 "both `direction` and `reversal_hours` say which way the mill turns; give one of "
                 "the two");
}

void check_fits(const std::vector<const CaseTable*>& tables, const Case& mill,
                const std::vector<OperatingChange>& changes, CaseProblems& problems) {
  Case with_changes = mill;
  with_changes.campaign.operation = changes;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i].counts.empty()) continue;
    const double filling = computed_filling(as_operated(with_changes, std::vector{i}));
    if (filling > most_filling)
      problems.add(tables[i]->line,
                   fmt::format("the charge does not fit (filling {:.3g}, at most {}); lower it",
                               filling, most_filling));
  }
}

std::vector<OperatingChange> changes_in(const std::vector<const CaseTable*>& tables,
                                        const CaseDocument& document, const Case& mill,
                                        CaseProblems& problems) {
  std::vector<OperatingChange> changes;
  const CaseTable& charge = *document.find("charge");
  Fillings fillings{optional_real(charge, "total_filling"), optional_real(charge, "ball_filling")};
  check_periods(tables, problems);
  for (const CaseTable* table : tables) {
    OperatingChange change;
    read_keys(operation_keys(), table, change);
    check_trigger(*table, mill, problems);
    check_counts(*table, mill, change, problems);
    read_speed(*table, mill, change, problems);
    read_fillings(*table, document, mill, fillings, change, problems);
    check_change(*table, change, mill, problems);
    changes.push_back(std::move(change));
  }
  if (problems.empty()) check_fits(tables, mill, changes, problems);
  return changes;
}

std::vector<OperatingChange> changes_in_csv(const std::filesystem::path& file,
                                            const CaseDocument& document, const Case& mill) {
  const auto rows = read_operation_csv(file);
  CaseProblems problems(file);
  for (const CaseTable& row : rows) check_against_schema(row, problems);
  problems.throw_if_any();
  std::vector<const CaseTable*> tables;
  for (const CaseTable& row : rows) tables.push_back(&row);
  auto changes = changes_in(tables, document, mill, problems);
  problems.throw_if_any();
  return changes;
}

}  // namespace

std::vector<OperatingChange> build_operation(const CaseDocument& document, const Case& mill,
                                             CaseProblems& problems) {
  const auto tables = document.all("campaign.operation");
  const CaseValue* const csv = document.find("campaign")->find("operation_csv");
  if (csv == nullptr) return changes_in(tables, document, mill, problems);
  std::vector<OperatingChange> changes;
  if (!tables.empty()) {
    problems.add(csv->line,
                 "both `operation_csv` and [[campaign.operation]] change the operation; give one "
                 "of the two");
    return changes;
  }
  const auto file = document.file.parent_path() / std::get<std::string>(csv->data);
  problems.attempt(csv->line, [&] { changes = changes_in_csv(file, document, mill); });
  return changes;
}

}  // namespace millwear
