#include <gmock/gmock.h>

#include <csignal>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const ReferenceCampaign& reference = ReferenceCampaign::of_a_reversal();

std::string status_of(const fs::path& campaign) {
  return millwear({"status", reference.mill().string(), "--out", campaign.string()}).out;
}

// The first cycle ends at the reversal, and the next begins with a charge of its own.
TEST(Reversal, EndsACycleAndMixesAnew) {
  EXPECT_THAT(reference.stages(),
              ElementsAre("cycle_000/mesh", "cycle_000/mix", "cycle_000/dem", "cycle_000/wear",
                          "cycle_001/mesh", "cycle_001/mix", "cycle_001/dem", "cycle_001/wear"));
  EXPECT_THAT(text_of(reference.path() / "ledger.jsonl"), HasSubstr("\"outcome\":\"reversed\""));
  EXPECT_THAT(status_of(reference.path()), HasSubstr("turning the other way"));
  EXPECT_THAT(text_of(reference.path() / "report.html"), HasSubstr("reversed at 3000"));
}

TEST(Reversal, KilledInTheReversedCycleItEndsInTheSameResults) {
  const TemporaryFolder folder;
  const fs::path campaign = folder.path() / "run";
  reference.copy_up_to("cycle_001/mesh", campaign);
  for (const StageName stage : {"cycle_001/mesh", "cycle_001/mix", "cycle_001/dem"}) {
    SCOPED_TRACE(stage);
    MillwearProcess process(run_into(campaign, reference.mill()));
    EXPECT_TRUE(process.wait_until([&] { return fs::exists(partial_of(campaign, stage)); }));
    process.send(SIGKILL);
    static_cast<void>(process.wait());
  }
  const Ended ended = millwear(run_into(campaign, reference.mill()));
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* const name : {"results/history.csv", "results/profiles.csv", "results/bins.h5"})
    EXPECT_TRUE(text_of(campaign / name) == text_of(reference.path() / name)) << name;
}

}  // namespace
}  // namespace millwear::crash
