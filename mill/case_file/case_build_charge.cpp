#include "mill/case_file/case_build_charge.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mill/case_file/case_build.h"
#include "mill/case_file/case_values.h"
#include "mill/case_keys/charge_keys.h"

namespace millwear {
namespace {

constexpr std::string_view filling_keys[] = {"total_filling", "ball_filling", "ball_material",
                                             "ore_material"};
constexpr std::string_view declared_keys[] = {"declared_total_filling", "declared_ball_filling"};

void refuse(const CaseTable& charge, std::string_view key, std::string_view why,
            CaseProblems& problems) {
  if (const CaseValue* const value = charge.find(key)) {
    problems.add(value->line, fmt::format("`{}` cannot stand here ({}); delete it", key, why));
  }
}

std::vector<ParticleClass> classes_from_counts(const CaseDocument& document,
                                               const std::vector<Material>& materials,
                                               double truncate_below, CaseProblems& problems) {
  std::vector<ParticleClass> classes;
  for (const CaseTable* table : document.all("charge.counts")) {
    ParticleClass c{};
    read_keys(count_keys(), table, c);
    c.material =
        material_index(materials, *table, "material", text_value(*table, "material"), problems);
    if (problems.empty() &&
        std::any_of(classes.begin(), classes.end(), [&c](const ParticleClass& other) {
          return other.material == c.material && other.diameter == c.diameter;
        })) {
      problems.add(table->line, fmt::format("particles of `{}` of {} m are counted twice; add up "
                                            "the two counts",
                                            materials[c.material].name, c.diameter));
    }
    if (c.diameter >= truncate_below) {
      classes.push_back(c);
    }
  }
  if (classes.empty()) {
    problems.add(document.line_of("charge", "truncate_below_m"),
                 fmt::format("no particle is left (sizes under {} m are cut off); lower "
                             "`truncate_below_m`",
                             truncate_below));
  }
  return classes;
}

std::vector<SieveClass> sieve_of(const CaseTable& table, CaseProblems& problems) {
  const std::vector<double> sizes = real_values(table, "size_m");
  const std::vector<double> retained = real_values(table, "retained_percent");
  if (sizes.size() != retained.size()) {
    problems.add(table.find("retained_percent")->line,
                 fmt::format("{} sizes but {} values of `retained_percent`; give one a size",
                             sizes.size(), retained.size()));
    return {};
  }
  const auto unsorted = std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>());
  if (unsorted != sizes.end()) {
    problems.add(table.find("size_m")->line,
                 fmt::format("`size_m` is not in order ({} m stands before {} m); list each size "
                             "once, largest first",
                             *unsorted, *(unsorted + 1)));
  }
  std::vector<SieveClass> sieve;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sieve.push_back({sizes[i], retained[i]});
  }
  return sieve;
}

/// The bulk share of the filling that belongs to each distribution, in their order.
std::vector<double> filling_shares(const CaseTable& charge,
                                   const std::vector<const CaseTable*>& distributions,
                                   CaseProblems& problems) {
  const double total = real_value(charge, "total_filling");
  if (distributions.size() == 1) {
    for (const std::string_view key : {"ball_filling", "ball_material", "ore_material"}) {
      refuse(charge, key, "one distribution takes the whole `total_filling`", problems);
    }
    return {total};
  }
  const auto balls = optional_real(charge, "ball_filling");
  const auto ball_material = optional_text(charge, "ball_material");
  const auto ore_material = optional_text(charge, "ore_material");
  if (distributions.size() > 2 || !balls || !ball_material || !ore_material) {
    problems.add(charge.line,
                 fmt::format("the filling cannot be shared out ({} distributions); give at most "
                             "two, with `ball_filling`, `ball_material` and `ore_material`",
                             distributions.size()));
    return {};
  }
  if (*balls >= total) {
    problems.add(
        charge.find("ball_filling")->line,
        fmt::format("`ball_filling` leaves no room for ore (balls {}, in all {}); lower it "
                    "or raise `total_filling`",
                    *balls, total));
  }
  std::vector<double> shares;
  for (const CaseTable* table : distributions) {
    const std::string material = text_value(*table, "material");
    if (material != *ball_material && material != *ore_material) {
      problems.add(table->line,
                   fmt::format("the distribution of `{}` has no filling (it is neither "
                               "`ball_material` nor `ore_material`); name it there",
                               material));
    }
    shares.push_back(material == *ball_material ? *balls : total - *balls);
  }
  if (text_value(*distributions[0], "material") == text_value(*distributions[1], "material")) {
    problems.add(distributions[1]->line,
                 "both distributions are of one material; give the balls and the ore one each");
  }
  return shares;
}

std::vector<ParticleClass> classes_from_filling(const CaseDocument& document,
                                                const std::vector<Material>& materials,
                                                const LinerSector& sector, double slice_length,
                                                const Charge& charge, CaseProblems& problems) {
  const CaseTable& table = *document.find("charge");
  const auto distributions = document.all("charge.distributions");
  const std::vector<double> shares = filling_shares(table, distributions, problems);
  const double inside = std::numbers::pi * sector.plate_radius * sector.plate_radius * slice_length;
  std::vector<ParticleClass> classes;
  for (std::size_t i = 0; i < distributions.size(); ++i) {
    const CaseTable& distribution = *distributions[i];
    const std::vector<SieveClass> sieve = sieve_of(distribution, problems);
    const std::size_t material = material_index(materials, distribution, "material",
                                                text_value(distribution, "material"), problems);
    if (!problems.empty()) {
      continue;
    }
    problems.attempt(distribution.line, [&] {
      const double solid = shares[i] * inside * (1.0 - charge.porosity);
      const auto counted = counts_for_volume(material, sieve, solid, charge.truncate_below);
      classes.insert(classes.end(), counted.begin(), counted.end());
    });
  }
  return classes;
}

}  // namespace

Charge build_charge(const CaseDocument& document, const std::vector<Material>& materials,
                    const LinerSector& sector, double slice_length, CaseProblems& problems) {
  const CaseTable& table = *document.find("charge");
  Charge charge;
  read_keys(charge_keys(), &table, charge);
  const bool by_counts = document.find("charge.counts") != nullptr;
  const bool by_filling = document.find("charge.distributions") != nullptr;
  if (by_counts == by_filling) {
    problems.add(table.line,
                 fmt::format("[charge] has {} [[charge.counts]] {} "
                             "[[charge.distributions]]; give one of the two",
                             by_counts ? "both" : "neither", by_counts ? "and" : "nor"));
    return charge;
  }
  if (by_filling && table.find("total_filling") == nullptr) {
    problems.add(
        table.line,
        "[charge] has no `total_filling` (its distributions are proportions only); add it");
    return charge;
  }
  if (by_counts) {
    for (const std::string_view key : filling_keys) {
      refuse(table, key, "the counts make the filling; `declared_` keys are only compared",
             problems);
    }
    charge.classes = classes_from_counts(document, materials, charge.truncate_below, problems);
  } else {
    for (const std::string_view key : declared_keys) {
      refuse(table, key, "the charge is made from `total_filling`", problems);
    }
    charge.declared = {optional_real(table, "total_filling"), optional_real(table, "ball_filling")};
    charge.classes =
        classes_from_filling(document, materials, sector, slice_length, charge, problems);
  }
  std::stable_sort(
      charge.classes.begin(), charge.classes.end(),
      [](const ParticleClass& a, const ParticleClass& b) { return a.diameter > b.diameter; });
  return charge;
}

}  // namespace millwear
