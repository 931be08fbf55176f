#include <gmock/gmock.h>

#include <csignal>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const ReferenceCampaign& reference = ReferenceCampaign::of_a_change();

// The first cycle ends at the change, and the next begins with the charge and the speed of it. The
// rows of history.csv end with speed, filling and feed rate.
TEST(Operation, EndsACycleAndMixesAnew) {
  EXPECT_THAT(reference.stages(),
              ElementsAre("cycle_000/mesh", "cycle_000/mix", "cycle_000/dem", "cycle_000/wear",
                          "cycle_001/mesh", "cycle_001/mix", "cycle_001/dem", "cycle_001/wear"));
  EXPECT_THAT(text_of(reference.path() / "ledger.jsonl"), HasSubstr("\"outcome\":\"changed\""));
  EXPECT_THAT(text_of(reference.path() / "cycle_001" / "dem" / "case_as_operated.toml"),
              AllOf(HasSubstr("count = 18\n"), HasSubstr("speed_rpm = 40\n")));
  EXPECT_THAT(text_of(reference.path() / "cycle_001" / "mix" / "charge.data"),
              HasSubstr("28 atoms"));
  EXPECT_THAT(text_of(reference.path() / "results" / "history.csv"), HasSubstr(",40,"));
  EXPECT_THAT(text_of(reference.path() / "report.html"), HasSubstr("from 3000 h on 40.00 rpm"));
}

TEST(Operation, KilledAfterTheChangeItEndsInTheSameResults) {
  const TemporaryFolder folder;
  const fs::path campaign = folder.path() / "run";
  reference.copy_up_to("cycle_001/mesh", campaign);
  for (const StageName stage : {"cycle_001/mix", "cycle_001/dem"}) {
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
