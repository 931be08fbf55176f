#include "orchestrator/stretch/step_follower.h"

#include "orchestrator/stretch/stretch_progress.h"

namespace millwear::orchestrator {

std::function<void(std::string_view)> step_follower(const std::string& name,
                                                    const liggghts::StretchSteps& steps,
                                                    Progress& progress, ShareOfWork share) {
  return [&progress, name, share, stretch = StretchProgress(steps)](std::string_view line) mutable {
    const bool went_on = stretch.goes_on();
    if (!stretch.take(line)) return;
    if (stretch.goes_on() && !went_on) progress.rename(name + ", going on");
    progress.advance(share.before + (share.after - share.before) * stretch.done());
  };
}

}  // namespace millwear::orchestrator
