#include "recorder/options/run_options.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear::recorder {
namespace {

using testing::HasSubstr;

TEST(RunOptions, NameTheDeck) { EXPECT_EQ(run_options({"--in", "deck.in"}).deck, "deck.in"); }

TEST(RunOptions, RefuseADeckThatIsMissing) {
  try {
    static_cast<void>(run_options({}));
    FAIL() << "no deck was taken";
  } catch (const Failure& problem) {
    EXPECT_EQ(problem.exit_code, ExitCode::usage);
    EXPECT_THAT(problem.what(), HasSubstr("--in is required; see run --help"));
  }
}

}  // namespace
}  // namespace millwear::recorder
