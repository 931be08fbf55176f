#pragma once
#include "tests/needs_liggghts/trial_run.h"

namespace millwear::trial {

/// A stretch that was run: its mesh, its steps and what it dumped (nothing while mixing).
struct Stretch {
  liggghts::StretchSteps steps;
  meshgen::LinerMesh mesh;
  Dumps dumps;
  liggghts::RunLog log;
};

/// The mill that makes a whole campaign in seconds: 120 balls, six lifters.
[[nodiscard]] Case small_mill(ContactPath path);

/// Changes the decks in a folder before they run.
using ChangeDeck = std::function<void(const std::filesystem::path&)>;

/// Packs the charge and mixes it in `folder` with the program's deck for so many steps.
Stretch mix(const Case& mill, const liggghts::StretchSteps& steps,
            const std::filesystem::path& folder, int ranks);

/// Measures on `liner` in `folder` with the program's deck, from the charge that the stretch in
/// the folder beside it, `previous`, left.
Stretch measure(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                const std::filesystem::path& folder, const std::string& previous, int cycle,
                int ranks, const ChangeDeck& change = {});

/// The same with the recorder.
Recording record(const Case& mill, const liggghts::StretchSteps& steps, const LinerProfile& liner,
                 const std::filesystem::path& folder, const std::string& previous, int ranks,
                 const ChangeDeck& change = {});

}  // namespace millwear::trial
