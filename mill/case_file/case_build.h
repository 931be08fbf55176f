#pragma once
#include "mill/case/case.h"
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// The parts of a `Case` from a document that has passed `check_against_schema`. Each adds what is
/// wrong to `problems`; what it returns is usable only where it added none.

[[nodiscard]] std::vector<Material> build_materials(const CaseDocument& document,
                                                    CaseProblems& problems);

[[nodiscard]] std::vector<MaterialPair> build_pairs(const CaseDocument& document,
                                                    const std::vector<Material>& materials,
                                                    CaseProblems& problems);

[[nodiscard]] DemSettings build_dem(const CaseDocument& document);

[[nodiscard]] CampaignSettings build_campaign(const CaseDocument& document, CaseProblems& problems);

[[nodiscard]] GaugeSettings build_gauge(const CaseDocument& document);

/// Speed [rad/s] of `mill`, whose [mill] table, liner and charge have been read: a whole
/// `speed_rpm` x pi / 30 in either form, so that a locked copy repeats it.
[[nodiscard]] double build_speed(const CaseDocument& document, const Case& mill,
                                 CaseProblems& problems);

/// Index of the material a key names; adds a problem and returns 0 where there is none of the name.
[[nodiscard]] std::size_t material_index(const std::vector<Material>& materials,
                                         const CaseTable& table, std::string_view key,
                                         std::string_view name, CaseProblems& problems);

}  // namespace millwear
