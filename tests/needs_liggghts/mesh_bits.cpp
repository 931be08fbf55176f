// Runs a deck and writes what LIGGGHTS keeps of its mesh `liner`, to the last bit, wherever the
// deck has the line `mesh_bits`:
//   mesh_bits ours|theirs DECK OUT      OUT.0 is that of rank 0, ...
#include <liggghts/fix_mesh_surface.h>
#include <liggghts/input.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <mpi.h>

#include <array>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

#include "recorder/turning/turning_mesh.h"

namespace {

using LAMMPS_NS::TriMesh;

/// Reaches what a mesh hides from all but its heirs.
class Opened : public TriMesh {
 public:
  using TriMesh::center_;
  using TriMesh::node_;
  using TriMesh::nodesLastRe_;
  using TriMesh::rBound_;
};

void write(std::ofstream& out, std::string_view name, const double* values, long count) {
  out << name << ' ' << count << '\n' << std::hexfloat;
  for (long i = 0; i < count; ++i) out << values[i] << '\n';
}

/// A container of scalars hands out its values, one of vectors a table of them, one of several
/// vectors an element a table of tables.
const double* values_of(LAMMPS_NS::ContainerBase& container) {
  void* const begin = container.begin_slow_dirty();
  if (container.nVec() > 1) return **static_cast<double***>(begin);
  if (container.lenVec() > 1) return *static_cast<double**>(begin);
  return static_cast<double*>(begin);
}

void write(std::ofstream& out, LAMMPS_NS::ContainerBase& container) {
  if (!container.isDoubleData() || container.size() == 0) return;
  write(out, container.id(), values_of(container),
        static_cast<long>(container.size()) * container.nVec() * container.lenVec());
}

void write_mesh(LAMMPS_NS::LAMMPS& liggghts, std::ofstream& out) {
  auto& fix = dynamic_cast<LAMMPS_NS::FixMeshSurface&>(*liggghts.modify->find_fix_id("liner"));
  TriMesh& mesh = *fix.triMesh();
  out << mesh.sizeLocal() << " own, " << mesh.sizeGhost() << " of others\n";
  write(out, mesh.*(&Opened::node_));
  write(out, mesh.*(&Opened::nodesLastRe_));
  write(out, mesh.*(&Opened::center_));
  write(out, mesh.*(&Opened::rBound_));
  for (int i = 0; i < mesh.prop().nElementProperties(); ++i)
    write(out, *mesh.prop().getElementPropertyBase(i));
  if (auto* const point =
          mesh.prop().getGlobalProperty<LAMMPS_NS::VectorContainer<double, 3>>("REFPT_turn"))
    write(out, *point);
  std::array<double, 6> box{};
  mesh.getGlobalBoundingBox().getBoxBounds(box.data(), box.data() + 3);
  write(out, "box", box.data(), 6);
}

void run(std::string_view whose, const char* deck, std::ofstream& out) {
  std::array<std::string, 3> words = {"liggghts", "-log", "none"};
  std::array<char*, 3> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  LAMMPS_NS::LAMMPS liggghts(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_WORLD);
  if (whose == "ours") millwear::recorder::turn_meshes_by_vectors(liggghts);
  std::ifstream lines(deck);
  for (std::string line; std::getline(lines, line);)
    if (line == "mesh_bits")
      write_mesh(liggghts, out);
    else
      liggghts.input->one(line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (argc == 4) {
    std::ofstream out(argv[3] + ("." + std::to_string(rank)));
    run(argv[1], argv[2], out);
  }
  MPI_Finalize();
}
