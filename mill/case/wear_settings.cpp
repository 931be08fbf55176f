#include "mill/case/wear_settings.h"

namespace millwear {

std::string_view name_of(SmoothingMethod method) {
  return method == SmoothingMethod::paper ? "paper" : "penalised";
}

}  // namespace millwear
