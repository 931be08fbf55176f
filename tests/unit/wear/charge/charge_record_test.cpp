#include "wear/charge/charge_record.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear::wear {
namespace {

ChargeRecord sample_record() {
  ChargeFieldSums sums({1.0, 8}, 0.25, 2);
  sums.begin_instant();
  sums.add({{0.1, 0.1, 0.2}, {1.0, 2.0, 3.0}, 0.2, 1.5, 1});
  sums.add_contact({0.1, 0.1, 0.2}, 1.0, 2.0, 1e-4);
  sums.add_pair_time(1e-4);
  return {sums.fields(), ChargeFrames{.across = {-1.0, 1.0},
                                      .along = {0.0, 0.25},
                                      .speed = {0.0, 9.0},
                                      .thinning = 2,
                                      .times = {0.0, 0.1},
                                      .mill_angles = {0.5, 0.6},
                                      .class_radius = {0.2, 0.1},
                                      .classes = {1, 0},
                                      .places = {1, 2, 3, 4, 5, 6, 65535, 8, 9, 10, 11, 12},
                                      .speeds = {7, 8, 9, 0},
                                      .state = std::vector<float>(18, 0.25F)}};
}

class ChargeFile : public testing::Test {
 protected:
  orchestrator::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "charge.h5";
};

TEST_F(ChargeFile, GivesBackTheRecord) {
  const ChargeRecord record = sample_record();
  write_charge(file, record);
  const ChargeRecord found = read_charge(file);
  EXPECT_EQ(found.fields.grid, record.fields.grid);
  EXPECT_EQ(found.fields.slice_length, 0.25);
  EXPECT_EQ(found.fields.instants, 1.0);
  EXPECT_EQ(found.fields.sums, record.fields.sums);
  EXPECT_EQ(found.fields.class_mass, record.fields.class_mass);
  EXPECT_EQ(found.fields.pair_duration, 1e-4);
  EXPECT_EQ(found.fields.shear_dissipation, record.fields.shear_dissipation);
  ASSERT_TRUE(found.frames);
  EXPECT_EQ(found.frames->across, record.frames->across);
  EXPECT_EQ(found.frames->thinning, 2U);
  EXPECT_EQ(found.frames->times, record.frames->times);
  EXPECT_EQ(found.frames->mill_angles, record.frames->mill_angles);
  EXPECT_EQ(found.frames->classes, record.frames->classes);
  EXPECT_EQ(found.frames->places, record.frames->places);
  EXPECT_EQ(found.frames->speeds, record.frames->speeds);
  EXPECT_EQ(found.frames->state, record.frames->state);
}

TEST_F(ChargeFile, HasTheSameBytesForTheSameRecord) {
  write_charge(file, sample_record());
  write_charge(folder.path() / "again.h5", sample_record());
  EXPECT_EQ(read_file(file), read_file(folder.path() / "again.h5"));
}

TEST_F(ChargeFile, WithAClassThatIsNotThereIsRefused) {
  ChargeRecord record = sample_record();
  record.frames->classes[1] = 2;
  write_charge(file, record);
  EXPECT_THROW((void)read_charge(file), ResultRejected);
}

TEST_F(ChargeFile, OfALaterPartOfAMeasurementHasNoFrames) {
  ChargeRecord later = sample_record();
  later.frames.reset();
  write_charge(file, later);
  EXPECT_FALSE(read_charge(file).frames);
  const ChargeRecord whole = joined(sample_record(), later);
  EXPECT_EQ(whole.fields.instants, 2.0);
  ASSERT_TRUE(whole.frames);
  EXPECT_EQ(whole.frames->places, sample_record().frames->places);
}

TEST_F(ChargeFile, OnAFullDiskFails) {
  EXPECT_THROW(write_charge("/dev/full", sample_record()), DiskError);
}

}  // namespace
}  // namespace millwear::wear
