#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear::orchestrator {

/// Adds a problem for every key of a table that is none of `known`.
void check_keys(const CaseTable& table, std::span<const std::string_view> known,
                CaseProblems& problems);

/// The text of a key; nothing where it is missing, and a problem where it is no text.
[[nodiscard]] std::optional<std::string> text_in(const CaseTable& table, std::string_view key,
                                                 CaseProblems& problems);

/// Likewise a whole number from `least` to `most`.
[[nodiscard]] std::optional<std::int64_t> whole_in(const CaseTable& table, std::string_view key,
                                                   std::int64_t least, std::int64_t most,
                                                   CaseProblems& problems);

/// Likewise true or false.
[[nodiscard]] std::optional<bool> switch_in(const CaseTable& table, std::string_view key,
                                            CaseProblems& problems);

/// A value as a number, if it is one.
[[nodiscard]] std::optional<double> number_of(const CaseValue& value);

/// A value as tables and folders show it.
[[nodiscard]] std::string label_of(const CaseValue& value);

}  // namespace millwear::orchestrator
