#include "mill/case_file/case_build_wear.h"

#include <fmt/format.h>

#include <array>

#include "mill/case_file/case_build.h"
#include "mill/case_file/case_values.h"
#include "mill/case_keys/wear_keys.h"

namespace millwear {
namespace {

constexpr std::array<std::string_view, 3> particle_keys = {"material", "smallest_diameter_m",
                                                           "largest_diameter_m"};

void refuse_key(const CaseTable& table, std::string_view key, WearLaw law, std::string_view why,
                std::string_view instead, CaseProblems& problems) {
  if (const CaseValue* const found = table.find(key)) {
    problems.add(found->line, fmt::format("`{}` does not go with the law `{}` ({}); {}", key,
                                          name_of(law), why, instead));
  }
}

void want_key(const CaseTable& table, std::string_view key, WearLaw law, CaseProblems& problems) {
  if (table.find(key) == nullptr) {
    problems.add(table.line, fmt::format("the law `{}` has no coefficient; add `{}`, or choose "
                                         "another `law`",
                                         name_of(law), key));
  }
}

void check_keys(const CaseTable& table, WearLaw law, CaseProblems& problems) {
  if (law == WearLaw::corrosion) {
    want_key(table, "depth_rate_m_per_year", law, problems);
    refuse_key(table, "specific_wear_rate_per_pa", law, "it takes time and no energy",
               "give `depth_rate_m_per_year`", problems);
    for (const std::string_view key : particle_keys) {
      refuse_key(table, key, law, "it is of no particles", "delete it", problems);
    }
    return;
  }
  want_key(table, "specific_wear_rate_per_pa", law, problems);
  refuse_key(table, "depth_rate_m_per_year", law, "only corrosion goes with time alone",
             "give `specific_wear_rate_per_pa`", problems);
}

WearMechanism mechanism_of(const CaseTable& table, const std::vector<KeyRow<WearMechanism>>& keys,
                           const std::vector<Material>& materials, CaseProblems& problems) {
  WearMechanism mechanism;
  read_keys(keys, &table, mechanism);
  check_keys(table, mechanism.law, problems);
  if (const auto name = optional_text(table, "material")) {
    mechanism.material = material_index(materials, table, "material", *name, problems);
  }
  return mechanism;
}

/// The first key of [wear] that gives the one law for all particles, or nullptr.
const CaseValue* law_of_wear(const CaseTable& wear) {
  for (const KeyRow<WearMechanism>& row : one_law_keys()) {
    if (const CaseValue* const found = wear.find(row.spec.key)) {
      return found;
    }
  }
  return nullptr;
}

std::vector<WearMechanism> build_mechanisms(const CaseDocument& document,
                                            const std::vector<Material>& materials,
                                            CaseProblems& problems) {
  const CaseTable& wear = *document.find("wear");
  const CaseValue* const one_law = law_of_wear(wear);
  const auto tables = document.all("wear.mechanisms");
  if (one_law != nullptr && !tables.empty()) {
    problems.add(one_law->line,
                 "[wear] has both a law of its own and [[wear.mechanisms]]; give the law in one of "
                 "the two");
    return {};
  }
  if (one_law == nullptr && tables.empty()) {
    problems.add(wear.line,
                 "[wear] has neither a law of its own nor [[wear.mechanisms]]; add "
                 "`specific_wear_rate_per_pa` for Archard's law, or mechanisms");
    return {};
  }
  if (tables.empty()) {
    return {mechanism_of(wear, one_law_keys(), materials, problems)};
  }
  std::vector<WearMechanism> mechanisms;
  for (const CaseTable* table : tables) {
    mechanisms.push_back(mechanism_of(*table, mechanism_keys(), materials, problems));
  }
  return mechanisms;
}

}  // namespace

WearSettings build_wear(const CaseDocument& document, const std::vector<Material>& materials,
                        CaseProblems& problems) {
  WearSettings wear;
  wear.mechanisms = build_mechanisms(document, materials, problems);
  read_keys(wear_keys(), document.find("wear"), wear);
  return wear;
}

}  // namespace millwear
