#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mill/case_keys/case_document.h"

namespace millwear {

/// Changes of operation as a plant historian exports them: a row a change, columns named by
/// quantity and unit (`operation_columns`). An empty field gives nothing. Each row becomes a table
/// [[campaign.operation]] whose values stand on the row's line.
/// Throws InputError (file:line) for a column of another name or unit, two columns of one quantity,
/// and a field that is no number.
[[nodiscard]] std::vector<CaseTable> read_operation_csv(const std::filesystem::path& file);

/// "`from_hours`, `from_days`, ...": the columns that the table may have.
[[nodiscard]] std::string operation_columns();

}  // namespace millwear
