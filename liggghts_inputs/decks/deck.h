#pragma once
#include <optional>
#include <string>

#include "liggghts_inputs/decks/stretch.h"
#include "mill/case/case.h"

namespace millwear::liggghts {

/// The liner mesh as LIGGGHTS takes it.
struct LinerMeshFile {
  std::string stl_file;  ///< as the deck names it, relative to the folder LIGGGHTS runs in
  std::size_t triangles;
};

/// The names of a stretch's files in the folder LIGGGHTS runs in.
namespace file_names {
inline constexpr const char* deck = "deck.in";
inline constexpr const char* contact_model = "contact_model.in";
inline constexpr const char* charge = "charge.data";
inline constexpr const char* log = "liggghts.log";
inline constexpr const char* restart = "charge.restart";
inline constexpr const char* contacts = "contacts.dump";
inline constexpr const char* spins = "spins.dump";
inline constexpr const char* torque = "torque.txt";
}  // namespace file_names

/// The neighbour skin the deck uses [m]: the case's, or by default the least particle's
/// radius (docs/how_to_run_dem_faster.md).
[[nodiscard]] double neighbour_skin(const Case& mill);

/// How `ranks` MPI ranks share the mill in the deck: as the case says, by default `charge`, where
/// the box of `charge_data_file` is cut; an odd number along the axis unless it is `balanced`.
[[nodiscard]] RankSplit rank_split(const Case& mill, int ranks);

/// How many columns across the mill the ranks make, each cut along the axis: two with
/// RankSplit::charge, one with `axis`; `balanced`, of the divisors of `ranks` the one with the
/// least surface between ranks, for a charge as wide as the mill.
[[nodiscard]] int rank_columns(const Case& mill, int ranks);

/// What the recorder is told of the columns: their number, or none where the cuts are LIGGGHTS's.
[[nodiscard]] std::optional<long> columns_to_balance(const Case& mill, int ranks);

enum class StretchKind { mix, trial, measure };

/// Which mesh stands in the mill: each has an ID of its own (see templates/contact_model.in), and a
/// charge comes from the restart file of another.
struct MeshInMill {
  StretchKind kind;
  int cycle;
  int chunk = 0;
};

/// Contact model, materials and liner, shared by both kinds of stretch.
[[nodiscard]] std::string contact_model_deck(const Case& mill, const StretchSteps& steps,
                                             const LinerMeshFile& mesh, const MeshInMill& which);

/// The deck of the first stretch: reads the packed charge, or where it is not the first chunk of
/// the mixing that of `previous_restart` (a path relative to the run's folder), mixes it, writes a
/// restart file. Like the others for `ranks` MPI ranks: one for an even number runs on any even
/// number, one for an odd number on any.
[[nodiscard]] std::string mixing_deck(const Case& mill, const StretchSteps& steps,
                                      const std::optional<std::string>& previous_restart,
                                      int ranks);

/// The deck of a measuring stretch on `worn`, the liner of this cycle, from the charge that
/// `previous_restart` (a path relative to the run's folder) holds.
[[nodiscard]] std::string measuring_deck(const Case& mill, const StretchSteps& steps,
                                         const LinerProfile& worn,
                                         const std::string& previous_restart, int ranks);

/// The deck that writes the charge of a restart file as a dump of one instant, with the columns of
/// the spins dump. Paths are relative to the run's folder.
[[nodiscard]] std::string charge_reading_deck(const std::string& restart_file,
                                              const std::string& charge_file);

/// The steps of one trial of LIGGGHTS's speed.
struct TrialSteps {
  long warm_up;
  long timed;
  [[nodiscard]] long total() const { return warm_up + timed; }
};

/// The deck of a trial of speed, with the case's `neighbour_skin` and `rank_split`, from the charge
/// that `previous_restart` holds. It leaves no restart file.
[[nodiscard]] std::string trial_deck(const Case& mill, const TrialSteps& steps,
                                     const std::string& previous_restart, int ranks);

}  // namespace millwear::liggghts
