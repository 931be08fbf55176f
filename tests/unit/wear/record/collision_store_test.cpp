#include "wear/record/collision_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "mill/base/failure.h"

namespace millwear::wear {
namespace {

namespace fs = std::filesystem;

/// The k-th of a row of collisions, every column its own: ends at k ms, after 2 ms.
Collision collision(int k) {
  return {.start = 1e-3 * (k - 2),
          .end = 1e-3 * k,
          .arc_length = 0.1 + k,
          .axial_place = 0.2 + k,
          .impact_speed = 0.3 + k,
          .impact_angle = 0.4 + k,
          .largest_normal_force = 0.5 + k,
          .normal_dissipation = 0.6 + k,
          .sliding_work = 0.7 + k,
          .shear_dissipation = 0.8 + k,
          .slip_distance = 0.9 + k,
          .particle = static_cast<std::uint32_t>(k + 1),
          .particle_class = static_cast<std::uint32_t>(k % 13),
          .row = k % 52 - 1,
          .unfinished = static_cast<Unfinished>(k % 4)};
}

std::vector<Collision> collisions(int count) {
  std::vector<Collision> all;
  for (int k = 0; k < count; ++k) all.push_back(collision(k));
  return all;
}

std::vector<Collision> read_all(const fs::path& path) {
  std::vector<Collision> all;
  for_each_collision(path, [&](const Collision& c) { all.push_back(c); });
  return all;
}

void write_all(const fs::path& path, const std::vector<Collision>& all) {
  CollisionWriter writer(path);
  writer.append(all);
  writer.close();
}

void expect_same(const Collision& a, const Collision& b) {
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.arc_length, b.arc_length);
  EXPECT_EQ(a.axial_place, b.axial_place);
  EXPECT_EQ(a.impact_speed, b.impact_speed);
  EXPECT_EQ(a.impact_angle, b.impact_angle);
  EXPECT_EQ(a.largest_normal_force, b.largest_normal_force);
  EXPECT_EQ(a.normal_dissipation, b.normal_dissipation);
  EXPECT_EQ(a.sliding_work, b.sliding_work);
  EXPECT_EQ(a.shear_dissipation, b.shear_dissipation);
  EXPECT_EQ(a.slip_distance, b.slip_distance);
  EXPECT_EQ(a.particle, b.particle);
  EXPECT_EQ(a.particle_class, b.particle_class);
  EXPECT_EQ(a.row, b.row);
  EXPECT_EQ(a.unfinished, b.unfinished);
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Lets no file grow beyond `bytes` while it lives: a write then fails as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    static_cast<void>(std::signal(SIGXFSZ, handler_));
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

class CollisionStore : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder = fs::path(testing::TempDir()) /
                    (std::string("collision_store_") +
                     testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::path file = folder / "events.h5";
};

TEST_F(CollisionStore, ReadsBackEveryColumnOfEveryCollision) {
  write_all(file, collisions(20000));
  const auto found = read_all(file);
  ASSERT_EQ(found.size(), 20000U);
  for (const int k : {0, 1, 8191, 8192, 19999})
    expect_same(found[static_cast<std::size_t>(k)], collision(k));
}

TEST_F(CollisionStore, HoldsNoneToo) {
  write_all(file, {});
  EXPECT_TRUE(read_all(file).empty());
}

TEST_F(CollisionStore, IsTheSameFileHoweverItIsCutIntoBlocks) {
  const auto all = collisions(9000);
  write_all(file, all);
  CollisionWriter writer(folder / "blocks.h5");
  for (std::size_t at = 0; at < all.size(); at += 7)
    writer.append(std::span(all).subspan(at, std::min<std::size_t>(7, all.size() - at)));
  writer.close();
  EXPECT_EQ(bytes_of(folder / "blocks.h5"), bytes_of(file));
}

// Two end at 1 ms: particle 3 on two sides, and particle 2.
TEST_F(CollisionStore, OrdersABlockByEndThenParticle) {
  Collision first = collision(1);
  first.particle = 2;
  Collision plate = collision(1);
  plate.particle = 3;
  plate.start = 0.0;
  Collision face = plate;
  face.start = 0.5e-3;
  Collision last = collision(2);
  last.particle = 1;
  write_all(file, {face, last, plate, first});
  const auto found = read_all(file);
  ASSERT_EQ(found.size(), 4U);
  expect_same(found[0], first);
  expect_same(found[1], plate);
  expect_same(found[2], face);
  expect_same(found[3], last);
}

TEST_F(CollisionStore, RefusesABlockThatComesTooLate) {
  CollisionWriter writer(file);
  writer.append(std::vector{collision(5)});
  EXPECT_NO_THROW(writer.append(std::vector{collision(5)}));
  EXPECT_THROW(writer.append(std::vector{collision(4)}), Failure);
}

TEST_F(CollisionStore, EveryDatasetHasAUnit) {
  write_all(file, collisions(3));
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5G_info_t info{};
  ASSERT_GE(H5Gget_info(h5, &info), 0);
  EXPECT_EQ(info.nlinks, 15U);
  for (const char* name :
       {"start", "end", "arc_length", "axial_place", "impact_speed", "impact_angle",
        "largest_normal_force", "normal_dissipation", "sliding_work", "shear_dissipation",
        "slip_distance", "particle", "particle_class", "row", "unfinished"}) {
    EXPECT_GT(H5Aexists_by_name(h5, name, "unit", H5P_DEFAULT), 0) << name;
  }
  H5Fclose(h5);
}

TEST_F(CollisionStore, RefusesAFileThatWasNotClosed) {
  {
    CollisionWriter writer(file);
    writer.append(collisions(3));
  }
  EXPECT_THROW(static_cast<void>(read_all(file)), ResultRejected);
}

TEST_F(CollisionStore, RefusesAnotherVersion) {
  write_all(file, collisions(3));
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(h5, "format_version", H5P_DEFAULT);
  const int next = collision_format_version + 1;
  H5Awrite(attribute, H5T_NATIVE_INT, &next);
  H5Aclose(attribute);
  H5Fclose(h5);
  try {
    static_cast<void>(read_all(file));
    FAIL() << "read a file of a newer version";
  } catch (const ResultRejected& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr("version 2"));
  }
}

TEST_F(CollisionStore, RefusesATruncatedFile) {
  write_all(file, collisions(20000));
  const auto whole = fs::file_size(file);
  for (const auto part : {whole - 1, whole / 2, whole / 8, std::uintmax_t{0}}) {
    fs::resize_file(file, part);
    EXPECT_THROW(static_cast<void>(read_all(file)), ResultRejected) << part << " of " << whole;
  }
}

TEST_F(CollisionStore, RefusesAMissingFile) {
  EXPECT_THROW(static_cast<void>(read_all(file)), DiskError);
}

// The disk fills at the first byte, in the middle, and with the last block.
TEST_F(CollisionStore, SaysThatTheDiskIsFull) {
  const auto all = collisions(200000);
  write_all(file, all);
  const auto whole = fs::file_size(file);
  for (const auto room : {std::uintmax_t{0}, whole / 8, whole / 2, whole - 4096, whole - 1}) {
    const SmallFiles limit(room);
    EXPECT_THROW(write_all(folder / "full.h5", all), DiskError) << room << " of " << whole;
  }
  EXPECT_NO_THROW(write_all(folder / "full.h5", all));
}

// HDF5 crashes when it tidies up after a full disk as the program exits; see QuietErrors.
TEST_F(CollisionStore, LeavesInOrderAfterAFullDisk) {
  const auto fill_the_disk_and_leave = [&] {
    const SmallFiles limit(100000);
    try {
      write_all(file, collisions(200000));
    } catch (const DiskError& full) {
      std::exit(static_cast<int>(full.exit_code));
    }
  };
  EXPECT_EXIT(fill_the_disk_and_leave(), testing::ExitedWithCode(6), "");
}

}  // namespace
}  // namespace millwear::wear
