#pragma once
#include <string>

namespace millwear::orchestrator {

/// A page in which what stands between `<!-- columns of NAME -->` and `<!-- end -->` is the table
/// of columns of that result file. Throws std::logic_error for a name that is none.
[[nodiscard]] std::string with_column_pages(const std::string& page);

}  // namespace millwear::orchestrator
