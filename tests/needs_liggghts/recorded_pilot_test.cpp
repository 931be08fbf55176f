#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numeric>
#include <sstream>

#include "liggghts_inputs/decks/deck.h"
#include "liggghts_inputs/outputs/torque_series.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_file.h"
#include "tests/needs_liggghts/mill_trial.h"

namespace millwear::trial {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;

constexpr const char* finnie = "finnie_";

/// One revolution of the pilot mill, recorded with the contacts between its balls, LIGGGHTS's own
/// wear beside it, and all its balls at the beginning and at the end.
struct PilotRevolution {
  Case mill;
  liggghts::StretchSteps steps;
  Recording recording;
  std::vector<liggghts::Snapshot> balls;
  double mill_work;                    ///< torque times angle [J]
  std::map<std::size_t, double> wear;  ///< by triangle: LIGGGHTS's Finnie wear times area [J]
};

constexpr std::size_t ball_columns = 10;

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const auto place = text.find(old);
  if (place == std::string::npos) throw std::logic_error("the deck holds no \"" + old + "\"");
  return text.replace(place, old.size(), by);
}

void change_decks(const fs::path& folder, const liggghts::StretchSteps& steps) {
  write_text(folder / names::contact_model,
             replaced(text_of(folder / names::contact_model), "curvature 1e-5",
                      "curvature 1e-5 wear finnie"));
  std::string deck = replaced(text_of(folder / names::deck), "include       contact_model.in",
                              "fix finnie all property/global k_finnie peratomtypepair 1 1.0\n"
                              "include       contact_model.in");
  deck = replaced(
      deck, "# millwear-recorder sees",
      fmt::format("dump balls all custom {} balls.dump id x y z vx vy vz omegax omegay omegaz\n"
                  "dump_modify balls sort id first yes format \"%d %.17g %.17g %.17g %.17g %.17g "
                  "%.17g %.17g %.17g %.17g\"\n"
                  "dump wear all mesh/vtk {} {}*.vtk id wear area\n# millwear-recorder sees",
                  steps.measure_steps, steps.measure_steps, finnie));
  write_text(folder / names::deck, deck);
}

/// The values of one cell array of a legacy VTK file, which holds it as a field or as scalars.
std::vector<double> cell_values(const std::string& vtk, const std::string& name,
                                std::size_t count) {
  auto place = vtk.find("\n" + name + " 1 ");
  if (place == std::string::npos) place = vtk.find("SCALARS " + name);
  if (place == std::string::npos) throw std::runtime_error("no \"" + name + "\" in the VTK file");
  place = vtk.find('\n', place + 1);
  if (vtk.compare(place + 1, 12, "LOOKUP_TABLE") == 0) place = vtk.find('\n', place + 1);
  std::istringstream words(vtk.substr(place));
  std::vector<double> values(count);
  for (auto& value : values) words >> value;
  return values;
}

std::map<std::size_t, double> wear_by_triangle(const fs::path& file, std::size_t triangles) {
  const std::string vtk = text_of(file);
  const auto ids = cell_values(vtk, "meshid", triangles);
  const auto wear = cell_values(vtk, "wear", triangles);
  const auto area = cell_values(vtk, "area", triangles);
  std::map<std::size_t, double> by_triangle;
  for (std::size_t i = 0; i < triangles; ++i)
    by_triangle[static_cast<std::size_t>(ids[i])] = wear[i] * area[i];
  return by_triangle;
}

double work_of_torque(const fs::path& file, const Case& mill, const liggghts::StretchSteps& steps) {
  double sum = 0.0;
  const auto torque = liggghts::read_torque_series(text_of(file), file.string());
  for (const auto& value : torque) sum -= value.torque * mill.speed;
  return sum / static_cast<double>(torque.size()) * steps.measure_time();
}

const PilotRevolution& pilot_revolution() {
  static const PilotRevolution run = [] {
    Case mill = read_case(MILLWEAR_CASES "/pilot_mill/case.toml");
    mill.dem.contact_path = ContactPath::recorder;
    const auto plan = plan_steps(mill);
    const long revolution = plan.steps_per_revolution(mill.liner.sector.rows);
    const ScratchFolder scratch;
    mix(mill, {plan.time_step, revolution, 0, 20}, scratch.stage("mix"), 2);
    const liggghts::StretchSteps steps{plan.time_step, 0, revolution, 1, revolution};
    const auto folder = scratch.stage("dem");
    Recording recording = record(mill, steps, mill.liner, folder, "mix", 2,
                                 [&](const fs::path& decks) { change_decks(decks, steps); });
    const auto triangles = static_cast<std::size_t>(recording.record.triangles.cols());
    return PilotRevolution{
        mill,
        steps,
        std::move(recording),
        snapshots_of(text_of(folder / "balls.dump"), ball_columns),
        work_of_torque(folder / names::torque, mill, steps),
        wear_by_triangle(folder / fmt::format("{}{}.vtk", finnie, steps.total()), triangles)};
  }();
  return run;
}

/// Kinetic energy of all balls, with their spin, and their height's energy [J].
double energy_of(const Case& mill, const liggghts::Snapshot& balls) {
  constexpr double gravity = 9.81;
  double energy = 0.0;
  std::size_t ball = 0;
  for (const auto& kind : mill.charge.classes)
    for (std::size_t i = 0; i < kind.count; ++i, ++ball) {
      const auto row = balls.row(ball);
      const double mass = particle_mass(mill, kind);
      const double radius = 0.5 * kind.diameter;
      const Eigen::Vector3d velocity(row[4], row[5], row[6]);
      const Eigen::Vector3d spin(row[7], row[8], row[9]);
      energy += mass * (0.5 * velocity.squaredNorm() + gravity * row[3] +
                        0.2 * radius * radius * spin.squaredNorm());
    }
  return energy;
}

class RecordedPilot : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
  }
};

// What the mill's torque puts in over a revolution goes into the charge's energy and is dissipated:
// at the wall, between balls, and by rolling friction. Left over is what the rolling friction at
// the wall took (the mesh is not told that torque) and the change of the springs' energy.
TEST_F(RecordedPilot, EnergyClosesOverARevolution) {
  const auto& run = pilot_revolution();
  const auto& load = run.recording.record.load;
  ASSERT_TRUE(run.recording.record.pairs.has_value());
  const auto& pairs = *run.recording.record.pairs;
  const double gained =
      energy_of(run.mill, run.balls.back()) - energy_of(run.mill, run.balls.front());
  const double wall_normal = load.total(Measure::normal_dissipation).sum();
  const double wall_shear = load.total(Measure::shear_dissipation).sum();
  const double accounted = gained + wall_normal + wall_shear + pairs.normal_dissipation +
                           pairs.shear_dissipation + pairs.rolling_dissipation;
  const std::map<std::string, double> shares = {{"gained", gained},
                                                {"wall_normal", wall_normal},
                                                {"wall_shear", wall_shear},
                                                {"pairs_normal", pairs.normal_dissipation},
                                                {"pairs_shear", pairs.shear_dissipation},
                                                {"pairs_rolling", pairs.rolling_dissipation},
                                                {"left_over", run.mill_work - accounted}};
  RecordProperty("mill_work_j", fmt::format("{:.6g}", run.mill_work));
  for (const auto& [name, energy] : shares)
    RecordProperty(name + "_share", fmt::format("{:.5f}", energy / run.mill_work));
  EXPECT_GT(run.mill_work, 100.0);
  EXPECT_NEAR(accounted, run.mill_work, 0.01 * run.mill_work);
}

// LIGGGHTS integrates the same erosion in the run, triangle by triangle, from the forces it
// applies.
TEST_F(RecordedPilot, FinnieIsLiggghtsOwnTriangleByTriangle) {
  const auto& run = pilot_revolution();
  const Eigen::VectorXd mine =
      run.recording.record.triangles.row(static_cast<Eigen::Index>(Measure::finnie));
  ASSERT_EQ(static_cast<std::size_t>(mine.size()), run.wear.size());
  double worst = 0.0;
  std::size_t worn = 0;
  for (const auto& [triangle, theirs] : run.wear) {
    if (theirs <= 0.0) continue;
    ++worn;
    worst = std::max(worst, std::abs(mine[static_cast<Eigen::Index>(triangle)] / theirs - 1.0));
  }
  RecordProperty("triangles", std::to_string(run.wear.size()));
  RecordProperty("worn_triangles", std::to_string(worn));
  RecordProperty("worst_relative_difference", fmt::format("{:.2e}", worst));
  EXPECT_GT(worn, run.wear.size() / 2);
  EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace millwear::trial
