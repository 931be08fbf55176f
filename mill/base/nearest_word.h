#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace millwear {

/// The word of `known` that `word` was meant to be: least edit distance, at most a third of its
/// length; empty if there is none.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string_view>& known);

}  // namespace millwear
