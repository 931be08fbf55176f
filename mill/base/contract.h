#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace millwear {

/// What a function asks of its caller and no file of a user can break: sizes that agree, spans that
/// are not empty. Throws std::logic_error ("internal error", exit code 1) where it does not hold;
/// `contract` says in words what must hold. What a user can mend throws a Failure
/// (mill/base/failure.h).
inline void expect(bool holds, std::string_view contract) {
  if (!holds) throw std::logic_error("broken contract: " + std::string(contract));
}

}  // namespace millwear
