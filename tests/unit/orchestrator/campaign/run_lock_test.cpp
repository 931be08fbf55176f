#include "orchestrator/campaign/run_lock.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <thread>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

/// Another process that holds a lock until it is killed.
class Holder {
 public:
  explicit Holder(const std::filesystem::path& file) {
    int ready[2];
    if (::pipe(ready) != 0) throw std::runtime_error("no pipe");
    pid_ = ::fork();
    if (pid_ == 0) {
      const RunLock lock(file);
      if (::write(ready[1], "", 1) == 1) ::pause();
      ::_exit(1);
    }
    char byte;
    if (::read(ready[0], &byte, 1) != 1) throw std::runtime_error("no holder");
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Holder() { die(); }

  void die() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }
  [[nodiscard]] int pid() const { return pid_; }

 private:
  int pid_;
};

class Lock : public testing::Test {
 protected:
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / ".lock";
};

TEST_F(Lock, RefusesASecondHolderAndNamesTheFirst) {
  const Holder holder(file);
  try {
    const RunLock second(file);
    FAIL() << "locked twice";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit_code, ExitCode::locked);
    EXPECT_THAT(failure.what(), testing::HasSubstr(folder.path().string()));
    EXPECT_THAT(failure.what(),
                testing::HasSubstr("process " + std::to_string(holder.pid()) + " on "));
  }
  EXPECT_TRUE(is_locked(file));
}

TEST_F(Lock, GoesWithAKilledProcess) {
  Holder holder(file);
  holder.die();
  EXPECT_FALSE(is_locked(file));
  EXPECT_NO_THROW(RunLock{file});
}

TEST_F(Lock, IsWaitedForAsLongAsAsked) {
  Holder holder(file);
  EXPECT_THROW((RunLock{file, std::chrono::seconds{1}}), Failure);
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds{700});
    holder.die();
  });
  EXPECT_NO_THROW((RunLock{file, std::chrono::seconds{30}}));
}

TEST_F(Lock, GoesWithItsObject) {
  std::optional<RunLock> lock(std::in_place, file);
  EXPECT_TRUE(is_locked(file));
  lock.reset();
  EXPECT_FALSE(is_locked(file));
}

TEST_F(Lock, InAFolderThatIsNotThereIsADiskError) {
  EXPECT_FALSE(is_locked(folder.path() / "none" / ".lock"));
  EXPECT_THROW(RunLock{folder.path() / "none" / ".lock"}, DiskError);
}

}  // namespace
}  // namespace millwear::orchestrator
