#include <gmock/gmock.h>
#include <sys/mount.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A disk of a few megabytes in memory; taken away with this object.
class SmallDisk {
 public:
  SmallDisk() = default;
  ~SmallDisk() {
    if (mounted_) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool mount(const std::string& size) {
    mounted_ = ::mount("none", folder_.path().c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
    return mounted_;
  }
  void resize(const std::string& size) const {
    ASSERT_EQ(
        ::mount("none", folder_.path().c_str(), "tmpfs", MS_REMOUNT, ("size=" + size).c_str()), 0);
  }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
  bool mounted_ = false;
};

class FullDisk : public testing::Test {
 protected:
  void mount(const std::string& size) {
    if (!disk.mount(size)) GTEST_SKIP() << "no tmpfs can be mounted: " << std::strerror(errno);
  }

  SmallDisk disk;
  fs::path campaign = disk.path() / "run";
};

TEST_F(FullDisk, IsSeenBeforeLiggghtsStarts) {
  mount("1m");
  if (IsSkipped()) return;
  const Ended ended = millwear(run_into(campaign));
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.err, AllOf(HasSubstr(campaign.string()), HasSubstr("MB are free")));
  expect_not_published(campaign, "cycle_000/mix");
  disk.resize("200m");
  expect_resumes_to_the_same(campaign);
}

// gmsh may say anything where it finds no room.
TEST_F(FullDisk, IsSeenFromTheFirstFileOn) {
  for (const auto& size : {"4k", "8k", "12k", "20k", "40k", "100k"}) {
    SmallDisk tiny;
    if (!tiny.mount(size)) GTEST_SKIP() << "no tmpfs can be mounted: " << std::strerror(errno);
    const Ended ended = millwear(run_into(tiny.path() / "run"));
    EXPECT_EQ(ended.code, 6) << size;
    EXPECT_THAT(ended.err, HasSubstr((tiny.path() / "run").string())) << size;
  }
}

// Something else fills the disk while LIGGGHTS runs: LIGGGHTS itself does not notice.
TEST_F(FullDisk, IsSeenWhenItFillsDuringAStretch) {
  mount("80m");
  if (IsSkipped()) return;
  const StageName stage = "cycle_002/dem";
  ReferenceCampaign::get().copy_up_to(stage, campaign);
  const TemporaryFolder folder;
  const std::string path =
      put_mpirun(folder.path() / "programs",
                 "dd if=/dev/zero of=../../ballast bs=4096 2>/dev/null\nexec mpirun \"$@\"");

  const Ended ended = millwear(run_into(campaign), {.path = path});
  EXPECT_EQ(ended.code, 6);
  EXPECT_THAT(ended.err, HasSubstr("cycle 2 dem: the disk is full"));
  expect_not_published(campaign, stage);
  fs::remove(campaign / "ballast");
  expect_resumes_to_the_same(campaign);
}

}  // namespace
}  // namespace millwear::crash
