#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mill/case_keys/case_document.h"

namespace millwear {

/// Values of a table that has passed `check_against_schema`. A key that is missing has its default
/// of the schema; without one, `std::logic_error` is thrown (the `optional_` ones return nothing).
[[nodiscard]] double real_value(const CaseTable& table, std::string_view key);
[[nodiscard]] bool boolean_value(const CaseTable& table, std::string_view key);
[[nodiscard]] std::string text_value(const CaseTable& table, std::string_view key);
[[nodiscard]] std::vector<double> real_values(const CaseTable& table, std::string_view key);
[[nodiscard]] std::vector<std::string> text_values(const CaseTable& table, std::string_view key);
[[nodiscard]] std::vector<Eigen::Vector2d> point_values(const CaseTable& table,
                                                        std::string_view key);

[[nodiscard]] std::optional<double> optional_real(const CaseTable& table, std::string_view key);
[[nodiscard]] std::optional<std::string> optional_text(const CaseTable& table,
                                                       std::string_view key);

}  // namespace millwear
