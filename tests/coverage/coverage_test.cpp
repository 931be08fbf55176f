#include "orchestrator/study/coverage.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "orchestrator/results/history.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

/// Campaigns that lose the same in every hour, each its own share of 1 mm of height and plate and
/// 1 cm3/m of volume an hour, and predict an error of `error` of that.
Seeds even_campaigns(const std::vector<double>& shares, double error) {
  Seeds seeds;
  int seed = 0;
  for (const double share : shares) {
    ++seed;
    for (const double hours : {0.0, 10.0, 100.0})
      seeds.moments.push_back({seed, hours, 1.0 - 1e-3 * share * hours, 1e-3 * error * hours,
                               2.0 - 1e-3 * share * hours, 1e-3 * error * hours,
                               1e-6 * share * hours, 1e-6 * error * hours, 0.0});
    seeds.lives.push_back({seed, 100.0 / share, 100.0 - 1.96 * error, 100.0 + 1.96 * error});
  }
  return seeds;
}

// Shares 0.9, 1.0 and 1.1: at 50 h the volumes are 45, 50 and 55, with a standard deviation of 5.
TEST(Coverage, IsThePredictedErrorOverTheScatter) {
  const auto rows = coverage_of(even_campaigns({0.9, 1.0, 1.1}, 0.2));
  const auto& volume = rows.at(1);
  EXPECT_EQ(volume.measure, "volume, cm3/m");
  EXPECT_DOUBLE_EQ(volume.hours, 50.0);
  EXPECT_DOUBLE_EQ(volume.mean, 50.0);
  EXPECT_NEAR(volume.scatter, 5.0, 1e-12);
  EXPECT_NEAR(volume.predicted, 10.0, 1e-12);
  EXPECT_NEAR(volume.ratio, 2.0, 1e-12);
}

// Three campaigns know their scatter to 1 / sqrt(2 * 2).
TEST(Coverage, KnowsHowLittleAFewCampaignsTell) {
  const auto rows = coverage_of(even_campaigns({0.9, 1.0, 1.1}, 0.2));
  EXPECT_NEAR(rows.at(1).ratio_error, 2.0 * 0.5, 1e-12);
}

TEST(Coverage, HasFourAgesOfThreeMeasuresAndTheLife) {
  const auto rows = coverage_of(even_campaigns({0.9, 1.0, 1.1}, 0.2));
  ASSERT_EQ(rows.size(), 13U);
  EXPECT_EQ(rows.at(4).measure, "height, mm");
  EXPECT_NEAR(rows.at(11).scatter, 10.0, 1e-9);
  EXPECT_EQ(rows.back().measure, "life, h");
  EXPECT_TRUE(std::isnan(rows.back().hours));
  EXPECT_NEAR(rows.back().predicted, 0.2, 1e-12);
}

TEST(Coverage, TakesThreeCampaigns) {
  EXPECT_THROW(static_cast<void>(coverage_of(even_campaigns({0.9, 1.1}, 0.2))), std::logic_error);
}

TEST(Coverage, ReadsBackWhatIsKept) {
  const TemporaryFolder folder;
  const Seeds seeds = even_campaigns({0.9, 1.0, 1.1}, 0.2);
  write_seeds(folder.path(), seeds);
  const auto kept = coverage_of(read_seeds(folder.path()));
  const auto made = coverage_of(seeds);
  for (std::size_t i = 0; i < made.size(); ++i)
    EXPECT_NEAR(kept.at(i).ratio, made.at(i).ratio, 1e-4) << made.at(i).measure;
}

TEST(Roughness, RisesFromTheLeastSoFarOfTheSameCampaign) {
  const auto moment = [](int seed, double roughness) {
    return SeedMoment{seed, 0, 0, 0, 0, 0, 0, 0, roughness};
  };
  EXPECT_NEAR(greatest_rise_of_roughness(
                  {moment(1, 5.0), moment(1, 2.0), moment(1, 3.0), moment(1, 2.5), moment(2, 9.0)}),
              1.0, 1e-12);
}

struct Kept {
  const char* folder;
  std::size_t campaigns;
  double rise;  ///< of the roughness [m]
};

class KeptCampaigns : public testing::TestWithParam<Kept> {
 protected:
  [[nodiscard]] static Seeds seeds() {
    return read_seeds(std::filesystem::path(MILLWEAR_CASES) / GetParam().folder / "coverage");
  }
};
INSTANTIATE_TEST_SUITE_P(Mills, KeptCampaigns,
                         testing::Values(Kept{"pilot_mill", 16, 1e-6},
                                         Kept{"seed_mill_8m_desktop", 4, 2e-5}),
                         [](const auto& kept) { return kept.param.folder; });

// A liner under balls levels: a whole life long it becomes no rougher than it was.
TEST_P(KeptCampaigns, GrowNeitherFoldsNorPits) {
  EXPECT_LT(greatest_rise_of_roughness(seeds().moments), GetParam().rise);
}

// The same of the three campaigns of the 8 m mill as its case has it.
TEST(KeptReferences, OfTheSeedMillGrowNeitherFoldsNorPits) {
  const auto reference =
      std::filesystem::path(MILLWEAR_CASES) / "seed_mill_8m_desktop" / "reference";
  int kept = 0;
  for (const auto& entry : std::filesystem::directory_iterator(reference)) {
    std::vector<SeedMoment> moments;
    for (const HistoryRow& row : read_history_csv(entry.path() / "history.csv"))
      moments.push_back({1, row.operating_hours, 0, 0, 0, 0, 0, 0, row.roughness});
    EXPECT_LT(greatest_rise_of_roughness(moments), 2e-5) << entry.path();
    ++kept;
  }
  EXPECT_GT(kept, 0);
}

// The judge of the bands (scripts/studies/coverage.sh). A ratio of sixteen campaigns is known to a
// fifth, one of four to two fifths, so it may lie off the aim by twice that.
TEST_P(KeptCampaigns, ScatterAsTheyPredict) {
  ASSERT_EQ(seeds().lives.size(), GetParam().campaigns);
  for (const Coverage& row : coverage_of(seeds())) {
    const auto place = fmt::format("{} at {:.0f} h", row.measure, row.hours);
    EXPECT_GT(row.ratio + 2.0 * row.ratio_error, 0.8) << place;
    EXPECT_LT(row.ratio - 2.0 * row.ratio_error, 1.3) << place;
  }
}

}  // namespace
}  // namespace millwear::orchestrator
