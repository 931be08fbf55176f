#include "orchestrator/campaign/open_campaign.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

const CampaignStarter starter{"millwear", 2, "here"};

Case mill_of_seed(int seed) {
  Case mill = example_case();
  mill.dem.seed = seed;
  return mill;
}

/// A ledger with one published stage and no files.
Ledger with_a_stage(Ledger ledger) {
  ledger.entries.push_back({{0, StageKind::mesh}, Outcome::go_on, {}, 1.0});
  return ledger;
}

class CampaignFolder : public testing::Test {
 protected:
  OpenCampaign to_run(int seed, std::optional<int> ranks = {}) const {
    return campaign_to_run(mill_of_seed(seed), folder, starter, ranks);
  }
  const TemporaryFolder place;
  const RunFolder folder{place.path()};
};

TEST_F(CampaignFolder, IsTakenByAnotherCaseWhileNoStageIsPublished) {
  keep_start(to_run(1));
  keep_start(to_run(2));
  EXPECT_THAT(read_file(folder.locked_case()), HasSubstr("seed = 2"));
  EXPECT_NO_THROW(static_cast<void>(campaign_of(mill_of_seed(2), folder)));
}

TEST_F(CampaignFolder, BelongsToItsCaseOnceAStageIsPublished) {
  OpenCampaign begun = to_run(1);
  begun.ledger = with_a_stage(begun.ledger);
  keep_start(begun);
  EXPECT_EQ(to_run(1).ledger.entries.size(), 1u);
  EXPECT_THAT(failure_of<InputError>([&] { static_cast<void>(to_run(2)); }),
              HasSubstr("the case differs"));
}

TEST_F(CampaignFolder, KeepsTheRanksItWasBegunWith) {
  OpenCampaign begun = to_run(1);
  begun.ledger = with_a_stage(begun.ledger);
  keep_start(begun);
  EXPECT_EQ(to_run(1, 2).campaign.ranks, 2);
  EXPECT_THAT(failure_of<Failure>([&] { static_cast<void>(to_run(1, 3)); }),
              HasSubstr("was begun with 2 ranks"));
}

TEST_F(CampaignFolder, IsRunsAndTheNameUnlessOneIsGiven) {
  EXPECT_EQ(run_folder_of(mill_of_seed(1), "").root,
            std::filesystem::path("runs") / mill_of_seed(1).name);
  EXPECT_EQ(run_folder_of(mill_of_seed(1), "there").root, "there");
}

TEST_F(CampaignFolder, IsNoCampaignWhileItIsEmpty) {
  EXPECT_THAT(failure_of<Failure>([&] { static_cast<void>(campaign_of(mill_of_seed(1), folder)); }),
              HasSubstr("no campaign is here"));
  EXPECT_THAT(failure_of<Failure>([&] { static_cast<void>(campaign_with_loads(folder)); }),
              HasSubstr("no campaign is here"));
  EXPECT_FALSE(campaign_up_to_mixing(folder));
}

}  // namespace
}  // namespace millwear::orchestrator
