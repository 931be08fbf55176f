#include "liggghts_inputs/outputs/snapshot_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <rapidcheck/gtest.h>

#include "mill/base/failure.h"
#include "tests/support/dump_text.h"

namespace millwear::liggghts {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Seen {
  long step;
  std::vector<double> values;
  bool operator==(const Seen&) const = default;
};

/// Reads a dump of three columns in pieces of the given sizes, over and over.
std::vector<Seen> read_in_pieces(std::string_view dump, const std::vector<std::size_t>& sizes) {
  std::vector<Seen> seen;
  SnapshotReader reader("contacts.dump", 3, [&](const Snapshot& snapshot) {
    seen.push_back({snapshot.step, snapshot.values});
  });
  for (std::size_t i = 0; !dump.empty(); ++i) {
    const auto size = std::min(dump.size(), sizes[i % sizes.size()]);
    reader.feed(dump.substr(0, size));
    dump.remove_prefix(size);
  }
  reader.finish();
  return seen;
}

/// What reading a dump of three columns is refused with; empty if it is taken.
std::string refusal(const std::string& dump) {
  try {
    static_cast<void>(read_in_pieces(dump, {dump.size() + 1}));
    return {};
  } catch (const ResultRejected& problem) {
    return problem.what();
  }
}

const std::string three_snapshots = dump_text(0, {{1.5, -2e-7, 3.0}, {4.0, 5.0, 6.0}}) +
                                    dump_text(20, {}) + dump_text(40, {{7.0, 8.0, 9.0}});

TEST(SnapshotReader, ReadsStepsAndRows) {
  EXPECT_THAT(read_in_pieces(three_snapshots, {1000}),
              ElementsAre(Seen{0, {1.5, -2e-7, 3.0, 4.0, 5.0, 6.0}}, Seen{20, {}},
                          Seen{40, {7.0, 8.0, 9.0}}));
}

RC_GTEST_PROP(SnapshotReader, PiecesOfAnySizeGiveTheSameSnapshots, ()) {
  const auto sizes = *rc::gen::nonEmpty<std::vector<std::size_t>>(
      rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 90)));
  RC_ASSERT(read_in_pieces(three_snapshots, sizes) ==
            read_in_pieces(three_snapshots, {three_snapshots.size()}));
}

RC_GTEST_PROP(SnapshotReader, ReadsBackWhatWasPrinted, ()) {
  const auto numbers = *rc::gen::container<std::vector<double>>(30, rc::gen::arbitrary<double>());
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i + 3 <= numbers.size(); i += 3)
    rows.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  RC_ASSERT(read_in_pieces(dump_text(7, rows), {13}).front().values == numbers);
}

TEST(SnapshotReader, RefusesADumpTornAtAnyByte) {
  const auto whole = [](std::size_t length) {
    return length == 0 || three_snapshots.substr(length).starts_with("ITEM: TIMESTEP");
  };
  for (std::size_t length = 0; length < three_snapshots.size(); ++length)
    if (!whole(length)) {
      EXPECT_THAT(refusal(three_snapshots.substr(0, length)), StartsWith("contacts.dump:"))
          << "torn after " << length << " bytes";
    }
}

TEST(SnapshotReader, NamesTheLineOfABrokenRow) {
  const std::string head = dump_text(0, {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}});
  const auto with_last_row = [&](const std::string& row) {
    return head.substr(0, head.find("4 5 6")) + row + "\n";
  };
  ASSERT_EQ(refusal(with_last_row("4 5 6")), "");
  for (const char* const row : {"4 5", "4 5 6 7", "4 nan 6", "4 5 -nan", "4 inf 6", "4 5 x",
                                "4 5 6x", "", "4 5-6", "ITEM: TIMESTEP"})
    EXPECT_THAT(refusal(with_last_row(row)), StartsWith("contacts.dump:11: ")) << row;
  EXPECT_THAT(refusal(with_last_row("4 nan 6")), HasSubstr("column 2 of 3"));
}

TEST(SnapshotReader, RefusesRowsThatDoNotMatchTheirHeader) {
  const std::string one = dump_text(0, {{1.0, 2.0, 3.0}});
  EXPECT_THAT(refusal(one + "1 2 3\n"), StartsWith("contacts.dump:11: "));
  EXPECT_THAT(refusal(dump_text(0, {{1.0, 2.0, 3.0}}).replace(one.find("\n1\n"), 3, "\n2\n") + one),
              StartsWith("contacts.dump:11: "));
  EXPECT_THAT(refusal(dump_text(0, {}).replace(15, 1, "a")), StartsWith("contacts.dump:2: "));
  EXPECT_THAT(refusal("Segmentation fault\n"), StartsWith("contacts.dump:1: "));
}

TEST(SnapshotReader, HoldsOneSnapshotHoweverLongTheRun) {
  const std::string dump = dump_text(20, std::vector<std::vector<double>>(50, {1.25, 2.5, 3.75}));
  std::size_t capacity = 0;
  long snapshots = 0;
  SnapshotReader reader("contacts.dump", 3, [&](const Snapshot& snapshot) {
    capacity = snapshot.values.capacity();
    ++snapshots;
  });
  const auto feed = [&](int times) {
    for (int i = 0; i < times; ++i) {
      reader.feed(std::string_view(dump).substr(0, 200));
      reader.feed(std::string_view(dump).substr(200));
    }
  };
  feed(10);
  const auto first_capacity = capacity;
  const auto first_heap = mallinfo2().uordblks;
  feed(10000);
  EXPECT_EQ(snapshots, 10010);
  EXPECT_EQ(capacity, first_capacity);
  EXPECT_LE(mallinfo2().uordblks, first_heap + 4096);
}

}  // namespace
}  // namespace millwear::liggghts
