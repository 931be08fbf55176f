#include "orchestrator/stretch/chunk_run.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/example_case.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

class ChunkRun : public testing::Test {
 protected:
  void run(const std::string& deck = "deck", const std::string& depends_on = "2 ranks") {
    run_chunk(campaign,
              {chunk, depends_on, [&](const fs::path& into) { put_text(into / "deck.in", deck); },
               [&](const fs::path& into) {
                 ++simulated;
                 if (fails) throw std::runtime_error("killed");
                 put_text(into / "restart", "made from " + text_of(into / "deck.in"));
               }});
  }

  const TemporaryFolder folder;
  const Campaign campaign{example_case(), {folder.path()}, 1};
  const fs::path chunk = folder.path() / ".dem.chunk_0";
  int simulated = 0;
  bool fails = false;
};

TEST_F(ChunkRun, IsMadeOnce) {
  run();
  run();
  EXPECT_EQ(simulated, 1);
  EXPECT_EQ(text_of(chunk / "restart"), "made from deck");
  EXPECT_FALSE(fs::exists(chunk.string() + ".partial"));
}

TEST_F(ChunkRun, IsMadeAnewFromOtherInputs) {
  run();
  run("another deck");
  run("another deck", "4 ranks");
  EXPECT_EQ(simulated, 3);
  EXPECT_EQ(text_of(chunk / "restart"), "made from another deck");
}

TEST_F(ChunkRun, IsMadeAnewWhereAFileWasChanged) {
  run();
  put_text(chunk / "restart", "torn");
  run();
  EXPECT_EQ(simulated, 2);
  EXPECT_EQ(text_of(chunk / "restart"), "made from deck");
}

TEST_F(ChunkRun, LeavesNothingThatCountsWhereItFails) {
  fails = true;
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_FALSE(fs::exists(chunk));
  fails = false;
  run();
  EXPECT_EQ(text_of(chunk / "restart"), "made from deck");
}

}  // namespace
}  // namespace millwear::orchestrator
