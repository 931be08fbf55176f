#pragma once

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace millwear::recorder {

using MakeFix = LAMMPS_NS::Fix* (*)(LAMMPS_NS::LAMMPS* liggghts, int argument_count,
                                    char** arguments);

/// Has LIGGGHTS make every fix of this style by `make`. To be called before the line of the deck
/// that asks for one.
void make_fixes_by(LAMMPS_NS::LAMMPS& liggghts, const char* style, MakeFix make);

}  // namespace millwear::recorder
