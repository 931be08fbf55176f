#include "orchestrator/postprocess/dump_load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <numbers>

#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double radius = 0.025;  ///< of the first class of example_case
constexpr std::size_t triangles = 6;

/// A mill that hardly turns, of three time blocks.
Case still_mill() {
  Case mill = example_case();
  mill.speed = 1e-9;
  mill.wear.time_blocks = 3;
  return mill;
}

/// Which particles touch the plate at one step, each with 12 N.
struct Instant {
  long step;
  std::vector<int> touching;
};

std::string snapshot(long step, const std::string& columns, const std::vector<std::string>& rows) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ENTRIES\n{}\n"
      "ITEM: BOX BOUNDS ff pp ff\n-0.55 0.55\n0 0.2\n-0.55 0.55\nITEM: ENTRIES {} \n",
      step, rows.size(), columns);
  for (const auto& row : rows) text += row + " \n";
  return text;
}

/// Upwards, from the plate half way between two lifters.
Eigen::Vector2d inwards() {
  const LinerSector sector = example_case().liner.sector;
  return -to_mill(sector, point_at(sector, sector.plate_radius, 0.5 * sector.pitch()), 0, 0.0)
              .normalized();
}

std::string contacts_text(const std::vector<Instant>& instants) {
  const Eigen::Vector2d place = -example_case().liner.sector.plate_radius * inwards();
  const Eigen::Vector2d force = 12.0 * inwards();
  std::string text;
  for (const auto& instant : instants) {
    std::vector<std::string> rows;
    for (const int particle : instant.touching)
      rows.push_back(fmt::format("{} 5 {} {:.17g} {} {:.17g} {:.17g} 0 {:.17g} 0 0 0", 0, particle,
                                 place.x(), 0.1, place.y(), force.x(), force.y()));
    text += snapshot(instant.step,
                     "c_w[7] c_w[8] c_w[9] c_w[1] c_w[2] c_w[3] c_w[10] c_w[11] c_w[12] c_w[13] "
                     "c_w[14] c_w[15]",
                     rows);
  }
  return text;
}

std::string particles_text(const std::vector<Instant>& instants) {
  const Eigen::Vector2d centre = -(example_case().liner.sector.plate_radius - radius) * inwards();
  std::string text;
  for (const auto& instant : instants) {
    std::vector<std::string> rows;
    for (const int particle : instant.touching)
      rows.push_back(fmt::format("{} 1 {} {:.17g} 0.1 {:.17g} 0 0 0 0 0 0", particle, radius,
                                 centre.x(), centre.y()));
    text += snapshot(instant.step, "id type radius x y z vx vy vz omegax omegay omegaz", rows);
  }
  return text;
}

/// Dumped every 20 steps; the measurement begins at 10 and ends at 55.
const std::vector<Instant> instants = {{10, {7}}, {30, {7}}, {50, {7, 5001}}, {55, {7, 5001}}};

class PostprocessedLoad : public testing::Test {
 protected:
  HandRun run(const std::string& contacts, const std::string& particles) const {
    put_text(folder.path() / "contacts.dump", contacts);
    put_text(folder.path() / "particles.dump", particles);
    HandRun run;
    run.contacts = folder.path() / "contacts.dump";
    run.particles = folder.path() / "particles.dump";
    run.time_step = 1e-3;
    return run;
  }
  HandRun run() const { return run(contacts_text(instants), particles_text(instants)); }

  /// What the dumps are refused with, without the folder; empty if they are taken.
  std::string refusal(const HandRun& run, const Case& mill = still_mill()) const {
    try {
      static_cast<void>(load_of_dumps(mill, triangles, run));
      return {};
    } catch (const InputError& problem) {
      std::string text = problem.what();
      const std::string where = folder.path().string() + "/";
      for (std::size_t at = 0; (at = text.find(where)) != std::string::npos;)
        text.erase(at, where.size());
      return text;
    }
  }

  const TemporaryFolder folder;
};

double total(const WallLoad& load, Measure measure) { return load.total(measure).sum(); }

// 12 N over 45 ms of one particle and the last 25 ms of the other. The first touches from the
// beginning on: only the other one's collision is new. The numbers go beyond the case's counts.
TEST_F(PostprocessedLoad, CountsEveryStepOnce) {
  const DumpLoad found = load_of_dumps(still_mill(), triangles, run());
  const WallLoad& load = found.record.load;
  EXPECT_DOUBLE_EQ(load.duration, 0.045);
  EXPECT_EQ(total(load, Measure::samples), 5.0);
  EXPECT_EQ(total(load, Measure::events), 1.0);
  EXPECT_NEAR(total(load, Measure::normal_impulse), 12.0 * (0.045 + 0.025), 1e-12);
  EXPECT_NEAR(found.record.triangles(static_cast<Eigen::Index>(Measure::normal_impulse), 5),
              12.0 * (0.045 + 0.025), 1e-12);
  EXPECT_EQ(found.outline.sample_steps, 20);
  EXPECT_EQ(found.outline.contacts, 5u);
}

TEST_F(PostprocessedLoad, IsThatOfTheStepsAskedFor) {
  Case mill = still_mill();
  mill.wear.time_blocks = 1;
  HandRun part = run();
  part.after = 11;
  part.until = 50;
  const WallLoad load = load_of_dumps(mill, triangles, part).record.load;
  EXPECT_DOUBLE_EQ(load.duration, 0.020);
  EXPECT_NEAR(total(load, Measure::normal_impulse), 12.0 * 2 * 0.020, 1e-12);
}

TEST_F(PostprocessedLoad, RefusesDumpsThatAreNotWhole) {
  const std::string contacts = contacts_text(instants);
  const std::string particles = particles_text(instants);
  EXPECT_EQ(refusal(run()), "");
  EXPECT_THAT(refusal(run(contacts.substr(0, contacts.size() - 9), particles)),
              StartsWith("contacts.dump:"));
  EXPECT_THAT(refusal(run(contacts, "")), HasSubstr("particles.dump ends"));
  EXPECT_THAT(refusal(run("", "")), HasSubstr("contacts.dump: no snapshot lies"));
  EXPECT_THAT(refusal(run(contacts_text({instants[0]}), particles_text({instants[0]}))),
              HasSubstr("contacts.dump: one snapshot lies"));
  EXPECT_THAT(
      refusal(run(contacts_text({{10, {}}, {30, {}}}), particles_text({{10, {}}, {30, {}}}))),
      HasSubstr("contacts.dump: nothing touches the wall in 2 snapshots"));
  HandRun missing = run();
  missing.contacts = folder.path() / "none.dump";
  EXPECT_THAT(refusal(missing), StartsWith("none.dump: there is no such file"));
}

TEST_F(PostprocessedLoad, RefusesAMissingColumn) {
  std::string contacts = contacts_text(instants);
  contacts.replace(contacts.find("c_w[8]"), 6, "c_w[6]");
  EXPECT_THAT(refusal(run(contacts, particles_text(instants))),
              AllOf(StartsWith("contacts.dump:9: "), HasSubstr("no column c_w[8]")));
  std::string particles = particles_text(instants);
  particles.replace(particles.find("omegaz"), 6, "torque");
  EXPECT_THAT(refusal(run(contacts_text(instants), particles)),
              AllOf(StartsWith("particles.dump:9: "), HasSubstr("no column omegaz")));
}

TEST_F(PostprocessedLoad, RefusesDumpsOfTwoRuns) {
  auto other = instants;
  other[2].step = 49;
  EXPECT_THAT(refusal(run(contacts_text(instants), particles_text(other))),
              HasSubstr("contacts.dump has step 50 where particles.dump has step 49"));
  other = instants;
  other[2].touching = {7, 8};
  EXPECT_THAT(refusal(run(contacts_text(instants), particles_text(other))),
              HasSubstr("particle 5001 touches the wall at step 50"));
  EXPECT_THAT(
      refusal(run(contacts_text(instants) + contacts_text(instants), particles_text(instants))),
      AllOf(StartsWith("contacts.dump:"), HasSubstr("step 10 comes after step 55")));
}

TEST_F(PostprocessedLoad, RefusesAGapBetweenSnapshots) {
  const std::vector<Instant> with_gap = {{10, {7}}, {30, {7}}, {50, {7}}, {90, {7}}};
  EXPECT_THAT(refusal(run(contacts_text(with_gap), particles_text(with_gap))),
              HasSubstr("contacts.dump: step 90: the snapshot before is that of step 50"));
}

TEST_F(PostprocessedLoad, RefusesAnotherLiner) {
  EXPECT_THAT(
      [&] { static_cast<void>(load_of_dumps(still_mill(), 5, run())); },
      testing::ThrowsMessage<InputError>(HasSubstr("triangle 5, and the liner's mesh has 5")));
  HandRun turned = run();
  turned.angle = 0.5 * example_case().liner.sector.pitch();
  EXPECT_THAT(refusal(turned), AllOf(StartsWith("contacts.dump: "), HasSubstr("off the liner"),
                                     HasSubstr("--angle-deg")));
}

TEST_F(PostprocessedLoad, WantsASampleForEveryTimeBlock) {
  Case mill = still_mill();
  mill.wear.time_blocks = 4;
  EXPECT_THAT(refusal(run(), mill), HasSubstr("3 samples, and the case wants 4 time blocks"));
}

}  // namespace
}  // namespace millwear::orchestrator
