#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "liggghts_inputs/outputs/dump_columns.h"

namespace millwear::orchestrator {

/// A run of LIGGGHTS that the user made with a deck of their own: its dumps, and how the deck's
/// steps and axes stand to the mill of the case.
struct HandRun {
  std::filesystem::path contacts;   ///< `dump local` of a `compute wall/gran/local`
  std::filesystem::path particles;  ///< `dump custom` of all that touch the wall
  /// Keywords of the compute, which say what its columns are.
  std::string contact_keywords{liggghts::usual_contact_keywords};
  std::optional<std::filesystem::path> mesh{};  ///< STL that the deck reads
  double time_step = 0.0;                       ///< the deck's [s]
  std::optional<long> after{};  ///< the measurement begins with the first snapshot from this step
  std::optional<long> until{};  ///< ... and ends with the last up to this one
  double angle = 0.0;           ///< the liner's at `angle_step` [rad], see mill/liner/mill_frame.h
  long angle_step = 0;
  std::string turns_about = "+y";  ///< the deck's axis, by the right-hand rule
  std::string gravity = "-z";
};

}  // namespace millwear::orchestrator
