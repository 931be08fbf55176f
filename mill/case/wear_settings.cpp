#include "mill/case/wear_settings.h"

namespace millwear {

std::string_view name_of(SmoothingMethod method) {
  return method == SmoothingMethod::paper ? "paper" : "penalised";
}

std::string_view name_of(ShadowedSteel shadowed_steel) {
  return shadowed_steel == ShadowedSteel::kept ? "kept" : "closing";
}

}  // namespace millwear
