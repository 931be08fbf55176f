#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>
#include <tuple>

#include "meshgen/liner_mesh.h"
#include "meshgen/stl_file.h"
#include "tests/needs_liggghts/trial_run.h"
#include "tests/support/sample_liners.h"

namespace millwear::trial {
namespace {

/// A ball in the laboratory mill, which turns so fast that neighbours are found anew every 40
/// steps. The mesh is looked at between two searches, in the step of one, and after a new start.
constexpr const char* deck = R"(
atom_style granular
atom_modify map array
boundary f {boundary} f
newton off
communicate single vel yes
units si
processors {processors}
region reg block -0.8 0.8 {slice} -0.8 0.8 units box
create_box 2 reg
neighbor 0.008 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5e6 5e6
fix m2 all property/global poissonsRatio peratomtype 0.3 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.5 0.5 0.5 0.5
fix m4 all property/global coefficientFriction peratomtypepair 2 0.4 0.4 0.4 0.4
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 0.01 0.01 0.01 0.01
pair_style gran model hertz tangential history rolling_friction cdt
pair_coeff * *
timestep 2e-5
fix integr all nve/sphere
fix liner all mesh/surface/stress file liner.stl type 2
fix wall all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes liner
{motion}
create_atoms 1 single 0.0 0.05 -0.44505
set group all diameter 0.03 density 7800
thermo_modify lost ignore
run 31
mesh_bits
run 1 pre no post no
mesh_bits
run 100 pre no post no
mesh_bits
run 57
mesh_bits
write_restart mesh.restart
)";

constexpr const char* periodic = "p";
constexpr const char* standing = "f";

struct Motion {
  const char* name;
  const char* lines;
  const char* boundary;  ///< along the mill's axis
};

void PrintTo(const Motion& motion, std::ostream* out) { *out << motion.name; }

std::string bits(const std::string& whose, const Motion& motion, int ranks,
                 const std::filesystem::path& folder) {
  const double slice = 0.12;
  meshgen::write_stl(
      meshgen::build_liner_mesh(meshgen::test::laboratory_liner(), slice, {.tolerance = 0.45e-3}),
      folder / "liner.stl");
  const bool wraps = motion.boundary == periodic;
  write_text(folder / "deck.in",
             fmt::format(fmt::runtime(deck), fmt::arg("boundary", motion.boundary),
                         fmt::arg("processors", ranks == 1 ? "1 1 1" : "2 1 1"),
                         fmt::arg("slice", wraps ? "0 0.12" : "-0.2 0.3"),
                         fmt::arg("motion", motion.lines)));
  const std::string command = fmt::format(
      "cd '{}' && mpirun --allow-run-as-root --oversubscribe -np {} {} {} deck.in bits >log 2>&1",
      folder.string(), ranks, MILLWEAR_MESH_BITS, whose);
  EXPECT_EQ(std::system(command.c_str()), 0) << text_of(folder / "log");
  std::string all = text_of(folder / "mesh.restart");
  EXPECT_GT(all.size(), 1000U);
  for (int rank = 0; rank < ranks; ++rank) all += text_of(folder / fmt::format("bits.{}", rank));
  return all;
}

class TurningMesh : public testing::TestWithParam<std::tuple<Motion, int>> {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

constexpr const char* turn =
    "fix turn all move/mesh mesh liner rotate origin 0 0 0 axis 0 1 0 period 0.6";
INSTANTIATE_TEST_SUITE_P(
    Motions, TurningMesh,
    testing::Combine(
        testing::Values(
            Motion{"about the mill's axis", turn, periodic},
            Motion{
                "about another axis",
                "fix turn all move/mesh mesh liner rotate origin 0.03 0.1 -0.02 axis 0.1 1 -0.05 "
                "period -0.6",
                standing},
            Motion{"of two at once",
                   "fix turn all move/mesh mesh liner rotate origin 0 0 0 axis 0 1 0 period 0.6\n"
                   "fix slide all move/mesh mesh liner linear 0.5 0 0.3",
                   standing},
            Motion{"of a speed that changes",
                   "variable speed equal 1+step/100\n"
                   "fix turn all move/mesh mesh liner rotate/variable origin 0 0 0 axis 0 1 0 "
                   "omega v_speed",
                   periodic}),
        testing::Values(1, 2)));

// Nodes, centres, normals, edges, velocities, forces, the box and what a restart file holds.
TEST_P(TurningMesh, KeepsTheBitsOfLiggghtssOwn) {
  const auto& [motion, ranks] = GetParam();
  const ScratchFolder scratch;
  const auto theirs = bits("theirs", motion, ranks, scratch.stage("theirs"));
  const auto ours = bits("ours", motion, ranks, scratch.stage("ours"));
  for (const char* part :
       {"\nnode ", "\ncenter ", "\nedgeVec ", "\nsurfaceNorm ", "\nv ", "\nbox "})
    EXPECT_NE(theirs.find(part), std::string::npos) << part;
  EXPECT_TRUE(ours == theirs);
}

}  // namespace
}  // namespace millwear::trial
