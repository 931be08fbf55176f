#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mill/base/failure.h"
#include "orchestrator/loads/spectra.h"

namespace millwear::orchestrator {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<SpectrumRow> example{{3, CollisionWith::liner, "steel_30mm", "",
                                        EnergyDirection::normal, 1e-3, 1.0 / 3.0, 12.5, 1e-7},
                                       {4, CollisionWith::particles, "steel_30mm", "ore_4.75mm",
                                        EnergyDirection::shear, 1e-9, 1e-8, 0.1, 2.5e-10}};

class SpectraCsv : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file); }
  void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }

  const std::filesystem::path file =
      std::filesystem::path(::testing::TempDir()) /
      (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
};

TEST_F(SpectraCsv, SaysWhatItHolds) {
  EXPECT_THAT(spectra_csv(example),
              StartsWith("# millwear spectra 1\ncycle,contact,class_a,class_b,direction,"
                         "energy_low_j,energy_high_j,events_per_second,power_w\n"
                         "3,liner,steel_30mm,,normal,0.001,"));
}

TEST_F(SpectraCsv, ReadsBackAsItWas) {
  write(spectra_csv(example));
  const auto read = read_spectra_csv(file);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].class_b, "");
  EXPECT_EQ(read[0].contact, CollisionWith::liner);
  EXPECT_EQ(read[0].energy_high, 1.0 / 3.0);
  EXPECT_EQ(read[1].cycle, 4);
  EXPECT_EQ(read[1].contact, CollisionWith::particles);
  EXPECT_EQ(read[1].class_a, "steel_30mm");
  EXPECT_EQ(read[1].class_b, "ore_4.75mm");
  EXPECT_EQ(read[1].direction, EnergyDirection::shear);
  EXPECT_EQ(read[1].energy_low, 1e-9);
  EXPECT_EQ(read[1].events_per_second, 0.1);
  EXPECT_EQ(read[1].power, 2.5e-10);
  EXPECT_EQ(spectra_csv(read), spectra_csv(example));
}

TEST_F(SpectraCsv, RefusesAWordThatItDoesNotKnowWithItsLine) {
  auto text = spectra_csv(example);
  text.replace(text.find("particles,steel"), 9, "particle");
  write(text);
  try {
    static_cast<void>(read_spectra_csv(file));
    FAIL();
  } catch (const ResultRejected& refused) {
    EXPECT_THAT(refused.what(), AllOf(StartsWith(file.string() + ":4: "), HasSubstr("`particle`"),
                                      HasSubstr("liner, particles")));
  }
}

TEST_F(SpectraCsv, RefusesAnotherVersion) {
  auto text = spectra_csv(example);
  text.replace(text.find(" 1\n"), 3, " 2\n");
  write(text);
  EXPECT_THROW(static_cast<void>(read_spectra_csv(file)), ResultRejected);
}

}  // namespace
}  // namespace millwear::orchestrator
