#include "orchestrator/results/calibrated_course.h"

#include <stdexcept>

namespace millwear::orchestrator {

std::string_view spoken(CourseUse use) {
  switch (use) {
    case CourseUse::fresh:
      return "new";
    case CourseUse::calibrated:
      return "calibrated";
    case CourseUse::held_out:
      return "held out";
  }
  throw std::logic_error("a use of no kind");
}

}  // namespace millwear::orchestrator
