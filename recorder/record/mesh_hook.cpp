#include "recorder/record/mesh_hook.h"

#include <liggghts/fix_mesh_surface.h>
#include <liggghts/lammps.h>
#include <liggghts/mesh_module.h>
#include <liggghts/modify.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mill/base/failure.h"
#include "recorder/liggghts/private_member.h"

namespace millwear::recorder {

// LIGGGHTS keeps a mesh's modules in two private members, and makes them from the style's name
// alone.
using LAMMPS_NS::FixMeshSurface;
using LAMMPS_NS::MeshModule;

struct Modules {
  using Type = std::map<std::string, MeshModule*> FixMeshSurface::*;
  friend Type member(Modules);
};
struct Order {
  using Type = std::vector<std::string> FixMeshSurface::*;
  friend Type member(Order);
};
template struct Reach<Modules, &FixMeshSurface::active_mesh_modules>;
template struct Reach<Order, &FixMeshSurface::mesh_module_order>;

FixMeshSurface& the_mesh(LAMMPS_NS::LAMMPS& liggghts) {
  std::vector<FixMeshSurface*> meshes;
  for (int i = 0; i < liggghts.modify->nfix; ++i)
    if (auto* mesh = dynamic_cast<FixMeshSurface*>(liggghts.modify->fix[i])) meshes.push_back(mesh);
  if (meshes.empty())
    throw InputError(
        "the deck has no `fix mesh/surface`, so there is no wall whose contacts could be recorded");
  if (meshes.size() > 1)
    throw InputError("the deck has more than one `fix mesh/surface`; give the liner in one");
  if (!meshes.front()->hasNeighList())
    throw InputError(std::string("no `fix wall/gran ... mesh` uses the mesh `") +
                     meshes.front()->id + "`, so nothing can touch it");
  return *meshes.front();
}

void hang_on(LAMMPS_NS::LAMMPS& liggghts, FixMeshSurface& mesh, MeshModule& module) {
  const std::string name = "millwear";
  (mesh.*member(Modules{}))[name] = &module;
  auto& order = mesh.*member(Order{});
  order.insert(order.begin(), name);
  const int fix = liggghts.modify->find_fix(mesh.id);
  liggghts.modify->fmask[fix] |= LAMMPS_NS::FixConst::END_OF_STEP;
  mesh.set_nevery(1);
}

}  // namespace millwear::recorder
