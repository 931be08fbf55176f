#include "wear/record/load_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "mill/base/failure.h"
#include "wear/record/load_read.h"
#include "wear/record/load_write.h"

namespace millwear::wear {
namespace {

namespace fs = std::filesystem;

WallLoad sample_load(double first_value) {
  WallLoad load{};
  load.slice_length = 0.25;
  load.rows = 52;
  load.duration = 10.5;
  load.bin_edges = Eigen::VectorXd::LinSpaced(101, 0.0, 0.7);
  load.class_count = 3;
  load.block_count = 4;
  for (std::size_t m = 0; m < measure_count; ++m) {
    load.values[m] = Eigen::MatrixXd::NullaryExpr(100, 12, [&](auto bin, auto column) {
      return first_value + static_cast<double>(bin) + 1000.0 * static_cast<double>(column);
    });
    load.rejected[m] = 0.125 * static_cast<double>(m);
  }
  return load;
}

LinerRecord sample_record(double first_value) {
  LinerRecord record{sample_load(first_value), no_charge_angles(4), empty_spectrum(3),
                     Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(measure_count), 5, 2.0),
                     PairRecord{0.3, empty_spectrum(6), 1.0, 2.0, 3.0}};
  add_contact(record.angles, 0.2, 7.0, 3);
  add_collision(record.spectrum, 1, 1e-3, 2e-4);
  add_collision(record.pairs->spectrum, 4, 1e-2, 2e-2);
  record.spectrum.unfinished[2] = 9.0;
  return record;
}

void expect_same(const ImpactSpectrum& a, const ImpactSpectrum& b) {
  EXPECT_EQ(a.normal_events, b.normal_events);
  EXPECT_EQ(a.normal_energy, b.normal_energy);
  EXPECT_EQ(a.shear_events, b.shear_events);
  EXPECT_EQ(a.shear_energy, b.shear_energy);
  EXPECT_EQ(a.unfinished, b.unfinished);
}

void expect_same(const WallLoad& a, const WallLoad& b) {
  EXPECT_EQ(a.slice_length, b.slice_length);
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.duration, b.duration);
  EXPECT_EQ(a.bin_edges, b.bin_edges);
  EXPECT_EQ(a.class_count, b.class_count);
  EXPECT_EQ(a.block_count, b.block_count);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.rejected, b.rejected);
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class LoadStore : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path file = folder / "load.h5";
};

TEST_F(LoadStore, ReadsBackWhatItWrote) {
  write_record(file, sample_record(0.1));
  expect_same(read_load(file), sample_load(0.1));
}

TEST_F(LoadStore, ReadsBackTheWholeRecord) {
  const LinerRecord written = sample_record(0.3);
  write_record(file, written);
  const LinerRecord found = read_record(file);
  expect_same(found.load, written.load);
  EXPECT_EQ(found.angles.contacts, written.angles.contacts);
  EXPECT_EQ(found.angles.normal_force, written.angles.normal_force);
  expect_same(found.spectrum, written.spectrum);
  EXPECT_EQ(found.triangles, written.triangles);
  ASSERT_TRUE(found.pairs.has_value());
  expect_same(found.pairs->spectrum, written.pairs->spectrum);
  EXPECT_EQ(found.pairs->duration, 0.3);
  EXPECT_EQ(found.pairs->rolling_dissipation, 3.0);
}

TEST_F(LoadStore, ReadsBackHowWellTheMeasurementKnowsItsPeaks) {
  LinerRecord written = sample_record(0.3);
  write_record(file, written);
  EXPECT_FALSE(read_record(file).goal);
  written.goal = MeasurementGoal{0.05, 0.071};
  write_record(file, written);
  ASSERT_TRUE(read_record(file).goal);
  EXPECT_EQ(read_record(file).goal->target_error, 0.05);
  EXPECT_EQ(read_record(file).goal->peak_error, 0.071);
  written.goal->peak_error = std::numeric_limits<double>::quiet_NaN();
  write_record(file, written);
  EXPECT_TRUE(std::isnan(read_record(file).goal->peak_error));
}

TEST_F(LoadStore, ReadsBackHowTheChargeMoved) {
  LinerRecord written = sample_record(0.3);
  write_record(file, written);
  EXPECT_FALSE(read_record(file).motion);
  written.motion = no_charge_motion(4);
  written.motion->census = Eigen::MatrixXd::NullaryExpr(
      6, 4, [](auto part, auto block) { return static_cast<double>(10 * part + block); });
  add_hit(written.motion->plate, 0.2, 1.0, 2.0, 3);
  add_hit(written.motion->lifter, -0.2, 3.0, 4.0, 1);
  write_record(file, written);
  const auto found = read_record(file).motion;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->census, written.motion->census);
  EXPECT_EQ(found->plate.mass, written.motion->plate.mass);
  EXPECT_EQ(found->plate.energy, written.motion->plate.energy);
  EXPECT_EQ(found->lifter.mass, written.motion->lifter.mass);
  EXPECT_EQ(found->lifter.energy, written.motion->lifter.energy);
}

TEST_F(LoadStore, ReadsBackWhereAroundTheTurnTheLoadIsTaken) {
  LinerRecord written = sample_record(0.3);
  write_record(file, written);
  EXPECT_FALSE(read_record(file).polar);
  written.polar = no_polar_load(12);
  written.polar->values[1](3, 71) = 5.0;
  written.polar->values[2](11, 0) = 7.0;
  write_record(file, written);
  EXPECT_EQ(read_record(file).polar, written.polar);
}

TEST_F(LoadStore, ReadsARecordWithoutParticleContacts) {
  LinerRecord written = sample_record(0.3);
  written.pairs.reset();
  written.triangles.resize(static_cast<Eigen::Index>(measure_count), 0);
  write_record(file, written);
  const LinerRecord found = read_record(file);
  EXPECT_FALSE(found.pairs.has_value());
  EXPECT_EQ(found.triangles.size(), 0);
}

TEST_F(LoadStore, KeepsTheLoadsOfEveryCycle) {
  const std::vector<StoredLoad> loads{{0, sample_load(0.1)}, {7, sample_load(0.2)}};
  write_loads(file, loads);
  const auto found = read_loads(file);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].cycle, 7);
  expect_same(found[1].load, loads[1].load);
}

// 4 x 64 x 600 doubles are more than HDF5's chunk cache of 1 MiB, 4 x 64 x 512 just fill it.
TEST_F(LoadStore, WritesTheSameBytesForLoadsThatWerePackedBefore) {
  std::vector<StoredLoad> loads;
  for (const int bins : {100, 512, 600}) {
    WallLoad load = sample_load(0.1);
    load.bin_edges = Eigen::VectorXd::LinSpaced(bins + 1, 0.0, 0.7);
    load.class_count = 4;
    load.block_count = 64;
    for (auto& values : load.values)
      values = Eigen::MatrixXd::NullaryExpr(bins, 256, [](auto bin, auto column) {
        return std::sqrt(static_cast<double>(bin * column));
      });
    loads.push_back({static_cast<int>(loads.size()), load});
    loads.push_back({static_cast<int>(loads.size()), sample_load(0.2)});
  }
  write_loads(file, loads);
  const auto first = bytes_of(file);
  std::vector<PackedLoad> packed_before;
  for (const auto& load : loads) packed_before.push_back(packed(load));
  write_loads(file, packed_before);
  EXPECT_TRUE(bytes_of(file) == first);
}

TEST_F(LoadStore, WritesTheSameBytesForTheSameLoad) {
  write_record(file, sample_record(0.1));
  const auto first = bytes_of(file);
  write_record(folder / "again.h5", sample_record(0.1));
  EXPECT_EQ(bytes_of(folder / "again.h5"), first);
}

TEST_F(LoadStore, EveryDatasetHasAUnit) {
  write_record(file, sample_record(0.1));
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  for (const char* name : {"slice_length", "rows", "duration", "bin_edges", "samples",
                           "normal_impulse", "sliding_work", "normal_dissipation", "rejected"}) {
    EXPECT_GT(H5Aexists_by_name(h5, name, "unit", H5P_DEFAULT), 0) << name;
  }
  H5Fclose(h5);
}

TEST_F(LoadStore, RefusesAnotherVersion) {
  write_record(file, sample_record(0.1));
  const hid_t h5 = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(h5, "format_version", H5P_DEFAULT);
  const int next = load_format_version + 1;
  H5Awrite(attribute, H5T_NATIVE_INT, &next);
  H5Aclose(attribute);
  H5Fclose(h5);
  try {
    static_cast<void>(read_load(file));
    FAIL() << "read a file of a newer version";
  } catch (const ResultRejected& refused) {
    EXPECT_THAT(refused.what(), testing::HasSubstr("version 5"));
  }
}

TEST_F(LoadStore, RefusesAnotherType) {
  write_record(file, sample_record(0.1));
  EXPECT_THROW(static_cast<void>(read_loads(file)), ResultRejected);
}

TEST_F(LoadStore, RefusesATruncatedFile) {
  write_record(file, sample_record(0.1));
  const auto whole = fs::file_size(file);
  for (const auto part : {whole - 1, whole / 2, whole / 8, std::uintmax_t{0}}) {
    fs::resize_file(file, part);
    EXPECT_THROW(static_cast<void>(read_load(file)), ResultRejected) << part << " of " << whole;
  }
}

TEST_F(LoadStore, RefusesAMissingFile) {
  EXPECT_THROW(static_cast<void>(read_load(file)), DiskError);
}

TEST_F(LoadStore, SaysThatTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP();
  EXPECT_THROW(write_record("/dev/full", sample_record(0.1)), DiskError);
}

}  // namespace
}  // namespace millwear::wear
