#pragma once

namespace LAMMPS_NS {
class LAMMPS;
class FixMeshSurface;
class MeshModule;
}  // namespace LAMMPS_NS

namespace millwear::recorder {

/// The only mesh of a script whose wall is about to run. Throws InputError where there is none,
/// more than one, or none that particles touch.
[[nodiscard]] LAMMPS_NS::FixMeshSurface& the_mesh(LAMMPS_NS::LAMMPS& liggghts);

/// Hangs a module on the mesh, before all others, and has its end_of_step called at every step. A
/// module that comes first sees forces before LIGGGHTS's own modules change their sign. To be done
/// before a run begins.
void hang_on(LAMMPS_NS::LAMMPS& liggghts, LAMMPS_NS::FixMeshSurface& mesh,
             LAMMPS_NS::MeshModule& module);

}  // namespace millwear::recorder
