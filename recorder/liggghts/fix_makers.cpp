#include "recorder/liggghts/fix_makers.h"

#include <liggghts/lammps.h>
#include <liggghts/modify.h>

#include <map>
#include <string>

#include "recorder/liggghts/private_member.h"

namespace millwear::recorder {

// LIGGGHTS makes a fix by its style's name, from a private table.
struct FixMakers {
  using Type = std::map<std::string, MakeFix>* LAMMPS_NS::Modify::*;
  friend Type member(FixMakers);
};
template struct Reach<FixMakers, &LAMMPS_NS::Modify::fix_map>;

void make_fixes_by(LAMMPS_NS::LAMMPS& liggghts, const char* style, MakeFix make) {
  (*(liggghts.modify->*member(FixMakers{})))[style] = make;
}

}  // namespace millwear::recorder
