#include "liggghts_inputs/outputs/stretch_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_inputs/decks/stretch.h"
#include "liggghts_inputs/outputs/run_log.h"
#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr StretchExpectation expected{.particles = 120, .triangles = 216, .last_step = 2000};

/// The log of a good stretch: settling to step 1000, then measuring to 2000.
const std::string good_log =
    "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0)\n"
    "Import and parallelization of mesh liner_000 containing 216 triangle(s) successful\n"
    "Step Atoms kinetic spinning torque \n"
    "       0      120   1.5   0.02    0\n"
    "    1000      120   1.4   0.03   -2.5\n"
    "Loop time of 1.1 on 1 procs for 1000 steps with 120 atoms\n"
    "Step Atoms kinetic spinning torque \n"
    "    1000      120   1.4   0.03   -2.5\n"
    "    2000      120   1.3   0.02   -2.75\n"
    "Loop time of 1.1 on 1 procs for 1000 steps with 120 atoms\n"
    "millwear: stretch complete\n";

std::string with(const std::string& old, const std::string& replacement) {
  std::string log = good_log;
  const auto place = log.rfind(old);
  EXPECT_NE(place, std::string::npos) << old;
  return log.replace(place, old.size(), replacement);
}

/// What a log is refused with; empty if it is taken.
std::string refusal(const std::string& log) {
  try {
    check_stretch_log(log, "mix/liggghts.log", expected);
    return {};
  } catch (const ResultRejected& problem) {
    return problem.what();
  }
}

TEST(StretchLog, GoodOneIsTaken) { EXPECT_EQ(refusal(good_log), ""); }

TEST(StretchLog, NamesTheLog) { EXPECT_THAT(refusal(""), StartsWith("mix/liggghts.log: ")); }

TEST(StretchLog, WithoutSentinelIsRefused) {
  EXPECT_THAT(refusal(with("millwear: stretch complete\n", "")),
              AllOf(HasSubstr("stopped half way"), HasSubstr("2000 of 2000")));
  EXPECT_THAT(refusal(good_log.substr(0, good_log.find("Loop time"))), HasSubstr("1000 of 2000"));
}

TEST(StretchLog, ThatOnlyEchoesTheSentinelIsRefused) {
  EXPECT_THAT(
      refusal(with("millwear: stretch complete\n", "print \"millwear: stretch complete\"\n")),
      HasSubstr("stopped half way"));
}

TEST(StretchLog, TornAnywhereIsRefused) {
  for (std::size_t length = 0; length + 1 < good_log.size(); ++length)
    EXPECT_NE(refusal(good_log.substr(0, length)), "") << "torn after " << length << " bytes";
}

TEST(StretchLog, WithALostAtomIsRefused) {
  EXPECT_THAT(refusal(with("2000      120", "2000      119")),
              HasSubstr("119 of 120 particles are left at step 2000"));
  EXPECT_THAT(refusal(with("0      120   1.5", "0      119   1.5")),
              HasSubstr("119 of 120 particles are left at step 0"));
}

TEST(StretchLog, WithTooFewTrianglesIsRefused) {
  EXPECT_THAT(refusal(with("216 triangle", "108 triangle")), HasSubstr("108 of the mesh's 216"));
  EXPECT_THAT(refusal(with("Import and", "import and")), HasSubstr("0 of the mesh's 216"));
}

TEST(StretchLog, WithValuesThatAreNotFiniteIsRefused) {
  for (const char* const broken :
       {"1.3   -nan    -2.75", "nan   0.02    -2.75", "1.3   0.02    inf"})
    EXPECT_THAT(refusal(with("1.3   0.02   -2.75", broken)), HasSubstr("not finite at step 2000"));
}

TEST(StretchLog, ThatEndsEarlyIsRefused) {
  EXPECT_THAT(refusal(with("    2000      120   1.3   0.02   -2.75\n", "")),
              HasSubstr("ended at step 1000 and not at 2000"));
}

TEST(StretchLog, TellsWhyLiggghtsStopped) {
  EXPECT_THAT(refusal(with("millwear: stretch", "ERROR: Lost atoms (thermo.cpp:427)\nmillwear:")),
              HasSubstr("ERROR: Lost atoms (thermo.cpp:427)"));
}

TEST(ThermoLine, IsFiveNumbersAndNothingElse) {
  ThermoLine line{};
  EXPECT_TRUE(read_thermo_line("    2000      120   1.3   0.02   -2.75 \r", line));
  EXPECT_EQ(line.step, 2000);
  EXPECT_EQ(line.atoms, 120u);
  EXPECT_EQ(line.torque, -2.75);
  for (const char* const other : {"", "2000 120 1.3 0.02", "2000 120 1.3 0.02 1 2",
                                  "Loop time of 1 on 1 procs", "2000 -1 1.3 0.02 1"})
    EXPECT_FALSE(read_thermo_line(other, line)) << other;
}

}  // namespace
}  // namespace millwear::liggghts
