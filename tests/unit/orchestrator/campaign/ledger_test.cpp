#include "orchestrator/campaign/ledger.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "orchestrator/campaign/run_folder.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const CampaignStart start{"millwear 0.1.0", "0123abcd", 2, "mill-pc"};
const LedgerEntry meshed{{0, StageKind::mesh}, Outcome::go_on, {{"liner.stl", "a1"}}, 0.25};
const LedgerEntry mixed{{0, StageKind::mix}, Outcome::go_on, {{"charge.restart", "b2"}}, 12.5};
const LedgerEntry worn{{3, StageKind::wear}, Outcome::plate_limit, {}, 1e-3};

class LedgerFile : public testing::Test {
 protected:
  void add_to_file(const std::string& text) const { put_text(file, text_of(file) + text); }
  [[nodiscard]] std::string refusal() const {
    return failure_of<ResultRejected>([&] { static_cast<void>(read_ledger(file)); });
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "ledger.jsonl";
};

TEST_F(LedgerFile, ComesBackAsItWasWritten) {
  write_ledger(file, {start, {}});
  for (const auto& entry : {meshed, mixed, worn}) append_entry(file, entry);
  const auto ledger = read_ledger(file);
  ASSERT_TRUE(ledger);
  EXPECT_EQ(ledger->start.program, start.program);
  EXPECT_EQ(ledger->start.case_hash, start.case_hash);
  EXPECT_EQ(ledger->start.ranks, 2);
  EXPECT_EQ(ledger->start.host, start.host);
  ASSERT_EQ(ledger->entries.size(), 3u);
  EXPECT_EQ(ledger->find({0, StageKind::mix})->outputs, mixed.outputs);
  EXPECT_EQ(ledger->find({0, StageKind::mix})->wall_seconds, 12.5);
  EXPECT_EQ(ledger->find({3, StageKind::wear})->outcome, Outcome::plate_limit);
  EXPECT_EQ(ledger->find({1, StageKind::mesh}), nullptr);
}

TEST_F(LedgerFile, IsNothingWhereThereIsNoFileOrNoWholeLine) {
  EXPECT_FALSE(read_ledger(file));
  put_text(file, "");
  EXPECT_FALSE(read_ledger(file));
  put_text(file, R"({"format_version":1,"progr)");
  EXPECT_FALSE(read_ledger(file));
}

// However short the last line was cut, the entries before it stand, the torn one is dropped, and
// the next one begins on a line of its own.
TEST_F(LedgerFile, DropsATornLastLineAndCutsItBeforeTheNextAppend) {
  write_ledger(file, {start, {}});
  append_entry(file, meshed);
  const std::string whole = text_of(file);
  append_entry(file, mixed);
  const std::string both = text_of(file);
  for (std::size_t length = whole.size(); length < both.size(); ++length) {
    put_text(file, both.substr(0, length));
    EXPECT_EQ(read_ledger(file)->entries.size(), 1u) << length;
    append_entry(file, mixed);
    EXPECT_EQ(text_of(file), both) << length;
  }
}

TEST_F(LedgerFile, WithADamagedMiddleLineIsRefusedWithItsPlace) {
  write_ledger(file, {start, {}});
  append_entry(file, meshed);
  add_to_file("{\"cycle\":0,\"stage\":\n");
  append_entry(file, mixed);
  EXPECT_THAT(refusal(), HasSubstr(file.string() + ":3: "));
}

TEST_F(LedgerFile, WithAnUnknownStageIsRefusedWithItsPlace) {
  write_ledger(file, {start, {}});
  add_to_file(R"({"cycle":0,"stage":"polish","outcome":"go_on","outputs":{},"wall_seconds":1})"
              "\n");
  EXPECT_THAT(refusal(), AllOf(HasSubstr(file.string() + ":2: "), HasSubstr("polish")));
}

TEST_F(LedgerFile, OfAnotherVersionIsRefused) {
  put_text(file,
           "{\"format_version\":2,\"program\":\"p\",\"case_hash\":\"h\",\"ranks\":1,"
           "\"host\":\"x\"}\n");
  EXPECT_THAT(refusal(), AllOf(HasSubstr(file.string() + ":1: "), HasSubstr("version 2")));
}

TEST_F(LedgerFile, ThatCannotBeAppendedToIsADiskError) {
  EXPECT_THROW(append_entry(folder.path() / "nowhere" / "ledger.jsonl", meshed), DiskError);
}

// XXH3-128 of no bytes is published with xxHash: 99aa06d3014798d86001c324468d497f.
TEST(Hash, IsXxh3Of128Bits) { EXPECT_EQ(hash_of_text(""), "99aa06d3014798d86001c324468d497f"); }

// 3 MB are read in three pieces.
TEST(Hash, OfAFileIsThatOfItsText) {
  const TemporaryFolder folder;
  const std::string text(3'000'000, 'w');
  put_text(folder.path() / "file", text);
  EXPECT_EQ(hash_of_file(folder.path() / "file"), hash_of_text(text));
  EXPECT_THROW(static_cast<void>(hash_of_file(folder.path() / "none")), DiskError);
}

class PublishedOutputs : public testing::Test {
 protected:
  PublishedOutputs() {
    std::filesystem::create_directories(file.parent_path());
    put_text(file, "a mesh");
  }
  [[nodiscard]] std::string refusal() const {
    return failure_of<ResultRejected>([&] { check_outputs(ledger, folder.path()); });
  }

  TemporaryFolder folder;
  std::filesystem::path file = RunFolder{folder.path()}.stage({0, StageKind::mesh}) / "liner.stl";
  Ledger ledger{
      start, {{{0, StageKind::mesh}, Outcome::go_on, {{"liner.stl", hash_of_text("a mesh")}}, 1}}};
};

TEST_F(PublishedOutputs, PassAsTheyWerePublished) { EXPECT_EQ(refusal(), ""); }

TEST_F(PublishedOutputs, AreNamedWhenOneWasChanged) {
  put_text(file, "a MESH");
  EXPECT_THAT(refusal(), HasSubstr(file.string() + ": was changed"));
}

TEST_F(PublishedOutputs, AreNamedWhenOneWasRemoved) {
  std::filesystem::remove(file);
  EXPECT_THAT(refusal(), HasSubstr(file.string() + ": was removed"));
}

}  // namespace
}  // namespace millwear::orchestrator
