#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "meshgen/liner_mesh.h"
#include "meshgen/stl_file.h"
#include "tests/support/sample_liners.h"

namespace millwear::meshgen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double slice = 0.12;

LinerMesh laboratory_mesh() {
  return build_liner_mesh(test::laboratory_liner(), slice, {.tolerance = 0.45e-3});
}

/// A ball of 30 mm on top of lifter 0 that slides along the axis at 0.5 m/s in the turning mill.
constexpr const char* deck = R"(
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
units si
processors 1 {ranks} 1
region reg block -0.55 0.55 0 {slice} -0.55 0.55 units box
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
fix grav all gravity 9.81 vector 0 0 -1
fix liner all mesh/surface/stress file liner.stl type 2
fix wall all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes liner
fix turn all move/mesh mesh liner rotate origin 0 0 0 axis 0 1 0 period 6.0
create_atoms 1 single 0.0 {y} -0.44505
set group all diameter 0.03 density 7800
velocity all set 0.0 0.5 0.0
compute omega all property/atom omegax
compute spin all reduce sum c_omega
variable along equal xcm(all,y)
variable height equal xcm(all,z)
variable spin equal c_spin
thermo_style custom step atoms f_liner[1] f_liner[2] f_liner[3] v_along v_height v_spin
thermo_modify lost ignore norm no format float %.15g
thermo 10
run 1500
print "DECK FINISHED"
)";

struct Thermo {
  std::string log;
  std::vector<std::array<double, 8>> rows;  ///< step atoms fx fy fz y height spin
};

Thermo run_liggghts(const LinerMesh& mesh, double y, int ranks) {
  const test::ScratchFolder folder;
  write_stl(mesh, folder / "liner.stl");
  std::ofstream(folder / "in.ball") << fmt::format(fmt::runtime(deck), fmt::arg("ranks", ranks),
                                                   fmt::arg("slice", slice), fmt::arg("y", y));
  const std::string command = fmt::format(
      "cd '{}' && mpirun --allow-run-as-root --oversubscribe -np {} liggghts -in in.ball 2>&1",
      folder.path().string(), ranks);
  Thermo run;
  FILE* const output = popen(command.c_str(), "r");
  for (std::array<char, 4096> line{}; fgets(line.data(), line.size(), output) != nullptr;) {
    run.log += line.data();
    std::istringstream words(line.data());
    std::array<double, 8> row{};
    std::size_t count = 0;
    while (count < row.size() && words >> row[count]) ++count;
    if (count == row.size()) run.rows.push_back(row);
  }
  EXPECT_EQ(pclose(output), 0) << run.log;
  return run;
}

/// The largest difference of a column, as a share of its largest value.
double difference(const Thermo& a, const Thermo& b, std::size_t column) {
  double largest = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < std::min(a.rows.size(), b.rows.size()); ++i) {
    largest = std::max(largest, std::abs(a.rows[i][column] - b.rows[i][column]));
    scale = std::max(scale, std::abs(a.rows[i][column]));
  }
  return largest / scale;
}

class MeshInLiggghts : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v liggghts mpirun > /dev/null") != 0) {
      GTEST_SKIP() << "liggghts or mpirun is not installed";
    }
  }
};

// A ball that slides over the edge of the slice meets the same wall as one in its middle.
TEST_F(MeshInLiggghts, BallDoesNotNoticeThePeriodicEdge) {
  const Thermo middle = run_liggghts(laboratory_mesh(), 0.035, 1);
  for (const int ranks : {1, 2}) {
    const Thermo across = run_liggghts(laboratory_mesh(), 0.115, ranks);
    EXPECT_THAT(across.log, HasSubstr("DECK FINISHED"));
    EXPECT_THAT(across.log, Not(HasSubstr("WARNING")));
    ASSERT_EQ(across.rows.size(), 151u);
    ASSERT_EQ(middle.rows.size(), 151u);
    EXPECT_EQ(across.rows.back()[1], 1.0);
    EXPECT_GT(across.rows.back()[5], slice);
    for (std::size_t i = 10; i < across.rows.size(); ++i) {
      ASSERT_LT(across.rows[i][4], 0.0) << "the ball has left the wall";
    }
    for (const std::size_t column : {3, 4, 6, 7}) {
      EXPECT_LT(difference(middle, across, column), 1e-9)
          << "ranks " << ranks << " column " << column;
    }
  }
}

// The same with a mesh 1 micrometre too long at the far edge: two triangles touch the ball there.
TEST_F(MeshInLiggghts, MeshLongerThanTheSliceIsNoticed) {
  LinerMesh too_long = laboratory_mesh();
  for (Eigen::Vector3d& vertex : too_long.vertices) {
    vertex.y() += vertex.y() == slice ? 1e-6 : 0.0;
  }
  const Thermo middle = run_liggghts(laboratory_mesh(), 0.035, 1);
  const Thermo across = run_liggghts(too_long, 0.115, 1);
  EXPECT_GT(difference(middle, across, 4), 1e-3);
}

}  // namespace
}  // namespace millwear::meshgen
