#pragma once
#include "mill/case_file/case_problems.h"
#include "mill/case_keys/case_document.h"

namespace millwear {

/// Compares every table and key of a document with the schema: unknown, missing, written twice,
/// of the wrong type, out of range, not finite, a name with characters that no name has.
void check_against_schema(const CaseDocument& document, CaseProblems& problems);

/// The same for the keys of one table, whose name the schema knows.
void check_against_schema(const CaseTable& table, CaseProblems& problems);

}  // namespace millwear
