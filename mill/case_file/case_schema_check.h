#pragma once
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// Compares every table and key of a document with the schema: unknown, missing, written twice,
/// of the wrong type, out of range, not finite, a name with characters that no name has.
void check_against_schema(const CaseDocument& document, CaseProblems& problems);

/// The word of `known` that `word` was meant to be: least edit distance, at most a third of its
/// length; empty if there is none.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string_view>& known);

}  // namespace millwear
