#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "liggghts_inputs/outputs/snapshot_reader.h"

namespace millwear::liggghts {

/// The words behind `compute ID all wall/gran/local` in the decks of this program.
inline constexpr std::string_view usual_contact_keywords = "pos id force_normal force_tangential";

/// Finds the columns that `ContactJoin` takes of wall contacts: point, triangle, particle, normal
/// and tangential force. LIGGGHTS names them c_ID[1], c_ID[2] ... and numbers them in an order of
/// its own, so `keywords`, those of the compute, say which is which. Throws InputError for a word
/// that LIGGGHTS does not know, or without one of pos, id, force_normal, force_tangential.
[[nodiscard]] ChooseColumns choose_contact_columns(std::string_view keywords);

/// Finds those that it takes of particles: id type radius x y z vx vy vz omegax omegay omegaz.
[[nodiscard]] ChooseColumns choose_spin_columns();

}  // namespace millwear::liggghts
