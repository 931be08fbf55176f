#include "orchestrator/stages/shared_stages.h"

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "mill/case_file/case_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

class SharedStages : public testing::Test {
 protected:
  /// A campaign's folder, which it fills with "made" unless another has.
  std::string filled(const char* campaign, const std::string& hash = "h") {
    const fs::path into = folder.path() / campaign;
    fs::create_directories(into);
    fill_shared(store, hash, into, [&] {
      ++worked;
      put_text(into / "load.h5", "made by " + std::string(campaign));
    });
    return text_of(into / "load.h5");
  }

  const TemporaryFolder folder;
  const fs::path store = folder.path() / "shared";
  int worked = 0;
};

TEST_F(SharedStages, AreMadeOnceAndTakenByTheOthers) {
  EXPECT_EQ(filled("a"), "made by a");
  EXPECT_EQ(filled("b"), "made by a");
  EXPECT_EQ(filled("c", "other"), "made by c");
  EXPECT_EQ(worked, 2);
  EXPECT_FALSE(fs::exists(folder.path() / "b" / ".hashes"));
}

TEST_F(SharedStages, AreMadeAnewWhereAFileWasChanged) {
  filled("a");
  fs::remove(store / "h" / "load.h5");  // a link to the campaign's own file, which stays
  put_text(store / "h" / "load.h5", "changed");
  EXPECT_EQ(filled("b"), "made by b");
  EXPECT_EQ(filled("c"), "made by b");
  EXPECT_EQ(text_of(folder.path() / "a" / "load.h5"), "made by a");
}

TEST_F(SharedStages, AreNotLeftByWorkThatFails) {
  const fs::path into = folder.path() / "a";
  fs::create_directories(into);
  EXPECT_THROW(fill_shared(store, "h", into, [] { throw std::runtime_error("no"); }),
               std::runtime_error);
  EXPECT_EQ(filled("b"), "made by b");
}

TEST_F(SharedStages, AreWaitedFor) {
  std::atomic<int> works = 0;
  const auto run = [&](const char* campaign) {
    const fs::path into = folder.path() / campaign;
    fs::create_directories(into);
    fill_shared(store, "h", into, [&] {
      ++works;
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      put_text(into / "load.h5", "made");
    });
  };
  std::thread other([&] { run("a"); });
  run("b");
  other.join();
  EXPECT_EQ(works, 1);
}

Case pilot() { return read_case(fs::path(MILLWEAR_CASES) / "pilot_mill" / "case.toml"); }

class HashOfDem : public testing::Test {
 protected:
  HashOfDem() {
    fs::create_directories(folder.path() / "cycle_000" / "mix");
    put_text(folder.path() / "cycle_000" / "mix" / "charge.restart", "a charge");
  }
  std::string hash(const Case& mill, StageKind kind = StageKind::dem, int ranks = 1) const {
    return hash_of_dem({mill, {folder.path()}, ranks}, {0, kind});
  }
  const TemporaryFolder folder;
};

TEST_F(HashOfDem, DoesNotDependOnWhatComesAfterTheDem) {
  Case other = pilot();
  other.name = "other";
  other.wear.mechanisms.front().specific_wear_rate *= 2.0;
  other.wear.mechanisms.front().law = WearLaw::finnie;
  other.wear.resolution = 0.01;
  other.campaign.height_limit = 0.02;
  other.campaign.scheme = Scheme::adaptive;
  EXPECT_EQ(hash(other), hash(pilot()));
  EXPECT_EQ(hash(other, StageKind::mix), hash(pilot(), StageKind::mix));
}

TEST_F(HashOfDem, DependsOnWhatIsSimulated) {
  const std::string same = hash(pilot());
  Case seed = pilot();
  seed.dem.seed = 2;
  EXPECT_NE(hash(seed), same);
  Case liner = pilot();
  liner.liner.nodes[2].y() += 1e-9;
  EXPECT_NE(hash(liner), same);
  EXPECT_NE(hash(pilot(), StageKind::dem, 2), same);
  put_text(folder.path() / "cycle_000" / "mix" / "charge.restart", "another charge");
  EXPECT_NE(hash(pilot()), same);
}

TEST_F(HashOfDem, OfMixingDoesNotDependOnTheMeasurement) {
  Case longer = pilot();
  longer.dem.measure_revolutions = 3.0;
  longer.wear.time_blocks = 12;
  EXPECT_NE(hash(longer), hash(pilot()));
  EXPECT_EQ(hash(longer, StageKind::mix), hash(pilot(), StageKind::mix));
}

TEST_F(HashOfDem, DependsOnTheLawWhereTheMeasurementGoesOnByIt) {
  Case one = pilot();
  one.dem.error_target = ErrorTarget{0.05, 2.0};
  Case other = one;
  other.wear.mechanisms.front().law = WearLaw::finnie;
  EXPECT_NE(hash(one), hash(other));
}

}  // namespace
}  // namespace millwear::orchestrator
