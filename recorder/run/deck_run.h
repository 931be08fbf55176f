#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace millwear::recorder {

/// Gives a deck to LIGGGHTS from top to bottom, line by line with what it includes; each `run` goes
/// to `take_run` instead. Throws InputError for a deck that is not there, or that would jump.
void run_deck(LAMMPS_NS::LAMMPS& liggghts, const std::filesystem::path& deck,
              const std::function<void(const std::string& line)>& take_run);

}  // namespace millwear::recorder
