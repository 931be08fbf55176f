#include <gmock/gmock.h>

#include <map>

#include "mill/base/whole_file.h"
#include "orchestrator/loads/kept_file.h"
#include "orchestrator/results/gather.h"
#include "orchestrator/results/result_files.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

constexpr int cycles = 6;

class KeptResults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    place = new TemporaryFolder;
    run = new SyntheticRun(synthetic_run(place->path(), cycles));
  }
  static void TearDownTestSuite() {
    delete run;
    delete place;
  }

  /// The bytes of every table after the results were published up to a cycle.
  static std::map<std::string, std::string> published(int cycle = cycles - 1) {
    const Ledger ledger = ledger_after(run->ledger, cycle);
    publish_results(run->campaign, ledger, gather(run->campaign, ledger));
    std::map<std::string, std::string> tables;
    for (const auto* name :
         {"history.csv", "profiles.csv", "replicates.csv", "spectra.csv", "bins.h5"})
      tables[name] = read_file(run->campaign.folder.results() / name);
    return tables;
  }
  static void forget() {
    for (int cycle = 0; cycle < cycles; ++cycle)
      fs::remove_all(kept_file(run->campaign.folder, cycle, "").parent_path());
  }
  static fs::path kept(int cycle, const char* name) {
    return kept_file(run->campaign.folder, cycle, name);
  }

  static TemporaryFolder* place;
  static SyntheticRun* run;
};

TemporaryFolder* KeptResults::place = nullptr;
SyntheticRun* KeptResults::run = nullptr;

TEST_F(KeptResults, AreTheResultsWithoutThemToTheByte) {
  forget();
  const auto anew = published();
  forget();
  for (int cycle = 0; cycle < cycles; ++cycle) static_cast<void>(published(cycle));
  EXPECT_TRUE(published() == anew);
}

// A cycle's band looks three loads ahead: of six cycles the first three are final.
TEST_F(KeptResults, AreKeptOnceNoLaterCycleCanChangeThem) {
  forget();
  static_cast<void>(published());
  EXPECT_TRUE(fs::exists(kept(2, "results")));
  EXPECT_FALSE(fs::exists(kept(3, "results")));
  EXPECT_TRUE(fs::exists(kept(5, "load")));
}

// The load itself is not looked at again: with what is kept it may be away.
TEST_F(KeptResults, SpareReadingALoadAgain) {
  const auto before = published();
  const auto load = run->campaign.folder.stage({1, StageKind::dem}) / stage_files::load;
  fs::rename(load, load.string() + ".away");
  EXPECT_TRUE(published() == before);
  fs::rename(load.string() + ".away", load);
}

TEST_F(KeptResults, AreWorkedOutAgainWhereTheyAreDamaged) {
  const auto before = published();
  for (const auto* name : {"load", "results"}) {
    const auto file = kept(1, name);
    const std::string whole = read_file(file);
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    std::string other_version = whole;
    other_version.replace(0, std::string("millwear kept 1").size(), "millwear kept 2");
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), whole.substr(0, 20),
                                       std::string(), flipped, other_version, whole + "x"}) {
      write_file(file, damaged);
      EXPECT_TRUE(published() == before) << name;
      EXPECT_TRUE(read_file(file) == whole) << name;
    }
  }
}

TEST(KeptKey, IsOfOneCase) {
  Case mill = synthetic_run(TemporaryFolder().path(), 0).campaign.mill;
  const auto key = kept_key(mill, "inputs");
  EXPECT_NE(kept_key(mill, "others"), key);
  mill.wear.mechanisms.front().specific_wear_rate *= 2.0;
  EXPECT_NE(kept_key(mill, "inputs"), key);
}

}  // namespace
}  // namespace millwear::orchestrator
