#pragma once
#include <string_view>

#include "liggghts_inputs/decks/stretch.h"

namespace millwear::orchestrator {

/// How far a stretch is, from the lines that LIGGGHTS and the recorder print. Where a measurement
/// goes on, its end moves; what is done never goes backwards.
class StretchProgress {
 public:
  /// A measurement that may go on is taken to end half way between its least and its greatest
  /// length until more is known.
  explicit StretchProgress(const liggghts::StretchSteps& planned);

  /// Takes a line and returns whether something is known anew from it.
  bool take(std::string_view line);

  [[nodiscard]] double done() const { return done_; }  ///< 0 ... 1
  [[nodiscard]] bool goes_on() const { return from_step_ > 0.0; }

 private:
  double expected_end_;  ///< step
  double from_step_ = 0.0;
  double from_done_ = 0.0;
  double done_ = 0.0;
};

}  // namespace millwear::orchestrator
