#include "mill/liner/drawn_liner.h"

#include <fmt/format.h>

#include "mill/base/failure.h"

namespace millwear {

LinerProfile no_drawings(const DrawnLiner& drawn, const LinerSector& /*sector*/) {
  throw InputError(
      fmt::format("{}: this program reads no drawings; give `profile_csv`", drawn.file.string()));
}

}  // namespace millwear
