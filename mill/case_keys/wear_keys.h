#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/key_row.h"

namespace millwear {

/// The keys of [wear] that give one law for all particles. A mechanism's coefficient is locked
/// under the key of its law.
[[nodiscard]] const std::vector<KeyRow<WearMechanism>>& one_law_keys();

/// The other keys of [wear].
[[nodiscard]] const std::vector<KeyRow<WearSettings>>& wear_keys();

/// The keys of [[wear.mechanisms]]; `material` is left to the builder.
[[nodiscard]] const std::vector<KeyRow<WearMechanism>>& mechanism_keys();

}  // namespace millwear
