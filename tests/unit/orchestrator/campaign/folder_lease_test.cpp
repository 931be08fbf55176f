#include "orchestrator/campaign/folder_lease.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class Lease : public testing::Test {
 protected:
  void leave(const LockHolder& holder, long seconds_ago) const {
    put_text(file, written(holder));
    const timespec then{std::time(nullptr) - seconds_ago, 0};
    const timespec times[] = {then, then};
    ASSERT_EQ(::utimensat(AT_FDCWD, file.c_str(), times, 0), 0);
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / ".lock.lease";
};

TEST_F(Lease, RefusesASecondHolderAndNamesTheFirst) {
  const FolderLease first(file);
  EXPECT_EQ(lease_holder(file), this_process());
  EXPECT_THAT([&] { FolderLease second(file); },
              ThrowsMessage<Failure>(HasSubstr(spoken(this_process()))));
}

TEST_F(Lease, GoesWithItsObject) {
  { const FolderLease lease(file); }
  EXPECT_FALSE(lease_holder(file));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(Lease, OfAProcessThatIsGoneIsTakenOver) {
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ::waitpid(gone, nullptr, 0);
  LockHolder left = this_process();
  left.process = gone;
  leave(left, 0);
  EXPECT_FALSE(lease_holder(file));
  const FolderLease lease(file);
  EXPECT_EQ(lease_holder(file), this_process());
}

TEST_F(Lease, OfAProcessThatItsParentHasNotWaitedForIsTakenOver) {
  const pid_t zombie = ::fork();
  if (zombie == 0) ::_exit(0);
  siginfo_t ended{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(zombie), &ended, WEXITED | WNOWAIT), 0);
  LockHolder left = this_process();
  left.process = zombie;
  leave(left, 0);
  EXPECT_NO_THROW(FolderLease{file});
  ::waitpid(zombie, nullptr, 0);
}

TEST_F(Lease, OfAnEarlierBootIsTakenOver) {
  LockHolder left = this_process();
  left.boot = "earlier";
  leave(left, 0);
  EXPECT_NO_THROW(FolderLease{file});
}

// Of another host nothing is known but that the file is touched.
TEST_F(Lease, OfAnotherHostIsTakenOverOnceItIsSilent) {
  leave({"node7", 4711, "a"}, 60);
  EXPECT_THAT([&] { FolderLease lease(file); },
              ThrowsMessage<Failure>(HasSubstr("process 4711 on node7")));
  leave({"node7", 4711, "a"}, 400);
  const FolderLease lease(file);
  EXPECT_EQ(lease_holder(file), this_process());
}

TEST_F(Lease, InAFolderThatIsNotThereIsADiskError) {
  EXPECT_THROW(FolderLease{folder.path() / "none" / ".lock"}, DiskError);
}

}  // namespace
}  // namespace millwear::orchestrator
