#include "orchestrator/campaign/output_path.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class OutputPath : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder.path() / "run" / "cycle_000");
    put_text(folder.path() / "run" / "ledger.jsonl", "{}\n");
    put_text(folder.path() / "case.toml", "name = \"a\"\n");
  }
  std::string refusal_of(const fs::path& file, const fs::path& input = {}) const {
    return failure_of<Failure>([&] { check_output_file("--csv", file, {input}); });
  }
  const TemporaryFolder folder;
};

TEST_F(OutputPath, MayBeANewFileOutsideEveryCampaign) {
  EXPECT_NO_THROW(check_output_file("--csv", folder.path() / "new.csv", {}));
  EXPECT_NO_THROW(check_output_folder("--out", folder.path() / "mesh"));
  EXPECT_NO_THROW(check_campaign_folder("--out", folder.path() / "run"));
}

TEST_F(OutputPath, IsNotAmongACampaignsOwnFiles) {
  EXPECT_THAT(refusal_of(folder.path() / "run" / "x.csv"), HasSubstr("own files"));
  EXPECT_THAT(refusal_of(folder.path() / "run" / "cycle_000" / "x.csv"), HasSubstr("own files"));
  EXPECT_THAT(refusal_of(folder.path() / "run" / ".." / "run" / "x.csv"), HasSubstr("own files"));
  fs::create_directory_symlink(folder.path() / "run", folder.path() / "link");
  EXPECT_THAT(refusal_of(folder.path() / "link" / "x.csv"), HasSubstr("own files"));
}

TEST_F(OutputPath, IsNotAnInput) {
  const fs::path input = folder.path() / "case.toml";
  EXPECT_THAT(refusal_of(folder.path() / "." / "case.toml", input), HasSubstr("name another"));
}

TEST_F(OutputPath, IsNoFolderAndLiesInOneThatIsThere) {
  EXPECT_THAT(refusal_of(folder.path()), HasSubstr("this is a folder"));
  EXPECT_THAT(refusal_of(folder.path() / "none" / "x.csv"), HasSubstr("there is no folder"));
}

TEST_F(OutputPath, OfAFolderIsNoCampaigns) {
  const auto refusal = [&](const char* name) {
    return failure_of<Failure>([&] { check_output_folder("--out", folder.path() / name); });
  };
  EXPECT_THAT(refusal("run"), HasSubstr("own files"));
  EXPECT_THAT(refusal("run/cycle_000"), HasSubstr("own files"));
}

TEST_F(OutputPath, OfACampaignDoesNotLieInAnother) {
  EXPECT_THAT(
      failure_of<Failure>([&] { check_campaign_folder("--out", folder.path() / "run" / "inner"); }),
      HasSubstr("own files"));
}

}  // namespace
}  // namespace millwear::orchestrator
