#include "wear/hdf5/hdf5_writer.h"

#include <gmock/gmock.h>

#include "mill/base/whole_file.h"
#include "tests/support/temporary_folder.h"
#include "wear/hdf5/hdf5_reader.h"

namespace millwear::wear {
namespace {

using testing::ElementsAre;

constexpr FileFormat format{"millwear test", 3};

class Hdf5File : public testing::Test {
 protected:
  void write(const std::filesystem::path& path) const {
    Hdf5Writer writer(path, format);
    const std::vector<std::uint16_t> places{65535, 0, 7, 1, 2, 3};
    const std::vector<std::uint8_t> kinds{0, 255};
    const std::vector<float> speeds{0.5F, -2.0F};
    const Handle group = writer.new_group("group");
    writer.write_values(group.id(), "places", "1", {2, 3}, places.data());
    writer.write_values(group.id(), "kinds", "1", {2}, kinds.data());
    writer.write_values(group.id(), "speeds", "m/s", {1, 2}, speeds.data());
    writer.write_number(writer.root(), "duration", "s", 0.1);
    writer.write_matrix(writer.root(), "matrix", "J", (Eigen::MatrixXd(2, 1) << 1, 2).finished());
    writer.publish();
  }

  orchestrator::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "numbers.h5";
};

TEST_F(Hdf5File, GivesBackNumbersOfEveryType) {
  write(file);
  const Hdf5Reader reader(file, format);
  const Handle group = reader.group("group");
  const auto places = reader.read_values<std::uint16_t>(group.id(), "places", 2);
  EXPECT_THAT(places.sizes, ElementsAre(2, 3));
  EXPECT_THAT(places.values, ElementsAre(65535, 0, 7, 1, 2, 3));
  EXPECT_THAT(reader.read_values<std::uint8_t>(group.id(), "kinds", 1).values, ElementsAre(0, 255));
  EXPECT_THAT(reader.read_values<float>(group.id(), "speeds", 2).values, ElementsAre(0.5F, -2.0F));
  EXPECT_EQ(reader.read_number(reader.root(), "duration"), 0.1);
  EXPECT_EQ(reader.read_matrix(reader.root(), "matrix"),
            (Eigen::MatrixXd(2, 1) << 1, 2).finished());
  EXPECT_THAT(reader.names(), ElementsAre("duration", "group", "matrix"));
}

TEST_F(Hdf5File, HasTheSameBytesForTheSameNumbers) {
  write(file);
  write(folder.path() / "again.h5");
  EXPECT_EQ(read_file(file), read_file(folder.path() / "again.h5"));
}

TEST_F(Hdf5File, OfAnotherTypeVersionOrShapeIsRefused) {
  write(file);
  EXPECT_THROW((Hdf5Reader{file, {"millwear other", 3}}), ResultRejected);
  EXPECT_THROW((Hdf5Reader{file, {"millwear test", 4}}), ResultRejected);
  const Hdf5Reader reader(file, format);
  EXPECT_THROW((void)reader.read_values(reader.root(), "duration", 2), ResultRejected);
  EXPECT_THROW((void)reader.read_number(reader.root(), "length"), ResultRejected);
}

TEST_F(Hdf5File, OnAFullDiskFails) { EXPECT_THROW(write("/dev/full"), DiskError); }

}  // namespace
}  // namespace millwear::wear
