#include "mill/case/campaign_settings.h"

namespace millwear {

std::string_view name_of(Scheme scheme) {
  return scheme == Scheme::adaptive ? "adaptive" : "threshold";
}

}  // namespace millwear
