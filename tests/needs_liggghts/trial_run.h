#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "liggghts_inputs/decks/stretch.h"
#include "liggghts_inputs/outputs/contact_join.h"
#include "liggghts_inputs/outputs/run_log.h"
#include "liggghts_inputs/outputs/stretch_log.h"
#include "meshgen/liner_mesh.h"
#include "mill/case/case.h"
#include "wear/charge/charge_record.h"
#include "wear/record/collision.h"
#include "wear/record/load_accumulator.h"

namespace millwear::trial {

/// A folder of its own for one test, removed when the test ends.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// A folder in it, made if it is not there.
  [[nodiscard]] std::filesystem::path stage(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

[[nodiscard]] bool liggghts_is_installed();

void write_text(const std::filesystem::path& file, const std::string& text);
[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// Builds the mesh of a liner as the program does and writes it to liner.stl in `folder`.
meshgen::LinerMesh write_liner_mesh(const Case& mill, const LinerProfile& liner,
                                    const std::filesystem::path& folder);

/// What LIGGGHTS wrote into the two pipes of a measuring deck, to the last byte.
struct Dumps {
  std::string contacts;
  std::string spins;
};

/// Runs the deck that lies in `folder`. Throws ResultRejected where its log does not show what is
/// expected.
Dumps run_deck(const std::filesystem::path& folder, int ranks,
               const liggghts::StretchExpectation& expected);

/// What the recorder made of a deck.
struct Recording {
  wear::LinerRecord record;
  wear::ChargeRecord charge;
  std::vector<wear::Collision> collisions;
  Dumps dumps;  ///< of the same run, where the deck dumps
};

/// Runs the deck that lies in `folder`, of a mill with this liner, with the recorder. Where the
/// steps go on, so does the measurement, and it may end behind the expected last step.
Recording record_deck(const Case& mill, const liggghts::StretchSteps& steps,
                      const LinerProfile& liner, const std::filesystem::path& folder, int ranks,
                      liggghts::StretchExpectation expected);

[[nodiscard]] liggghts::RunLog log_of(const std::filesystem::path& folder);

/// Every snapshot of a dump.
[[nodiscard]] std::vector<liggghts::Snapshot> snapshots_of(const std::string& dump,
                                                           std::size_t columns);

/// Hands every joined sample of the dumps to `take`.
void join_dumps(const Case& mill, const liggghts::StretchSteps& steps, const Dumps& dumps,
                const liggghts::ContactJoin::Take& take,
                const liggghts::ContactJoin::Take& begin = {});

/// The load of the dumps on `liner`, as the program accumulates it. Throws ResultRejected where a
/// contact lies off the profile.
[[nodiscard]] WallLoad load_of(const Case& mill, const liggghts::StretchSteps& steps,
                               const LinerProfile& liner, const Dumps& dumps);

/// Steel that Archard's law takes from the whole liner during the measurement [m3].
[[nodiscard]] double worn_volume(const Case& mill, const WallLoad& load);

}  // namespace millwear::trial
