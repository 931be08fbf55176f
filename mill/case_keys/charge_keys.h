#pragma once
#include <vector>

#include "mill/case/case.h"
#include "mill/case_keys/key_row.h"

namespace millwear {

/// The keys of [[materials]].
[[nodiscard]] const std::vector<KeyRow<Material>>& material_keys();

/// The keys of [[pairs]]; `materials` is left to the builder.
[[nodiscard]] const std::vector<KeyRow<MaterialPair>>& pair_keys();

/// The keys of [charge]; those of a charge by filling are left to the builder.
[[nodiscard]] const std::vector<KeyRow<Charge>>& charge_keys();

/// The keys of [[charge.counts]]; `material` is left to the builder.
[[nodiscard]] const std::vector<KeyRow<ParticleClass>>& count_keys();

/// The keys of [[charge.distributions]], all left to the builder.
[[nodiscard]] const std::vector<KeyRow<SieveClass>>& distribution_keys();

}  // namespace millwear
