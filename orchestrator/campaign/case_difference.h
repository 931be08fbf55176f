#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mill/case/case.h"

namespace millwear::orchestrator {

/// A key of a locked case, "[dem] `seed`", and its value as it is written there.
struct LockedValue {
  std::string key;
  std::string value;
};

/// All of them, defaults filled in.
[[nodiscard]] std::vector<LockedValue> locked_values(const Case& mill);

/// One key in which two cases differ, "[dem] `seed` (2, there 1)".
/// Compares what `locked_case_text` writes of both, defaults filled in.
[[nodiscard]] std::vector<std::string> differences(const Case& here, const Case& there);

/// `there` with the wear law and the campaign settings of `here`: what may differ between a
/// campaign and a law that is put to its loads. Throws InputError, naming file and keys, where
/// `here` differs in anything else; `folder` is the campaign's.
[[nodiscard]] Case with_law_of(const Case& here, const Case& there, std::string_view folder);

}  // namespace millwear::orchestrator
