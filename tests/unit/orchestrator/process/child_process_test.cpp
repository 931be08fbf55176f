#include "orchestrator/process/child_process.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "mill/base/failure.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

template <class Condition>
bool comes_true(Condition condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (std::chrono::steady_clock::now() < until) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return condition();
}

/// Whether a process runs: a dead one that nobody has waited for does not.
bool runs(int pid) {
  const std::string status = text_of(fs::path("/proc") / std::to_string(pid) / "stat");
  const auto name_end = status.rfind(')');
  return name_end != std::string::npos && status.at(name_end + 2) != 'Z';
}

int pid_in(const fs::path& file) {
  comes_true([&] { return text_of(file).ends_with('\n'); });
  return std::stoi(text_of(file));
}

/// A shell that starts a `sleep` as its child, writes its number to the file `pid` and waits for
/// it; told to end, it ends the sleep too, as mpirun does with its ranks.
const std::vector<std::string> sleeping_shell = {
    "/bin/sh", "-c", "trap 'kill $!; exit 0' TERM; sleep 100 & echo $! > pid; wait"};

class Child : public testing::Test {
 protected:
  TemporaryFolder folder;

  std::string printed_by(const ChildProcess& child) {
    std::string text;
    char piece[256];
    comes_true([&] {
      const ssize_t length = ::read(child.output(), piece, sizeof piece);
      if (length > 0) text.append(piece, static_cast<std::size_t>(length));
      return length == 0;
    });
    return text;
  }
};

TEST_F(Child, RunsInItsFolderWithBothOutputsInOnePipeAndNoInput) {
  ChildProcess child({"/bin/sh", "-c", "pwd; echo problem >&2; cat; exit 3"}, folder.path());
  EXPECT_EQ(printed_by(child), fs::canonical(folder.path()).string() + "\nproblem\n");
  EXPECT_EQ(child.wait(), 3);
}

TEST_F(Child, RunsOnFilesInThePlaceOfItsStreams) {
  put_text(folder.path() / "input", "read");
  const auto opened = [&](const char* name, int how) {
    return ::open((folder.path() / name).c_str(), how | O_CREAT | O_CLOEXEC, 0600);
  };
  const ChildFiles files{opened("input", O_RDONLY), opened("output", O_WRONLY),
                         opened("messages", O_WRONLY)};
  ChildProcess child({"/bin/sh", "-c", "cat; echo problem >&2"}, folder.path(), files);
  EXPECT_EQ(child.output(), -1);
  EXPECT_EQ(child.wait(), 0);
  for (const int file : {files.input, files.output, files.messages}) ::close(file);
  EXPECT_EQ(text_of(folder.path() / "output"), "read");
  EXPECT_EQ(text_of(folder.path() / "messages"), "problem\n");
}

TEST_F(Child, KilledGives128AndTheSignal) {
  ChildProcess child({"/bin/sh", "-c", "kill -9 $$"}, folder.path());
  EXPECT_EQ(child.wait(), 128 + SIGKILL);
}

TEST_F(Child, DiesWithItsObjectAndTakesItsGroupAlong) {
  std::optional<ChildProcess> child(
      std::in_place, std::vector<std::string>{"/bin/sh", "-c", "sleep 100 & echo $! > pid; wait"},
      folder.path());
  const int sleep = pid_in(folder.path() / "pid");
  ASSERT_TRUE(runs(sleep));
  child.reset();
  EXPECT_TRUE(comes_true([&] { return !runs(sleep); }));
}

TEST_F(Child, ThatIgnoresTheRequestToEndIsKilledInTheEnd) {
  std::optional<ChildProcess> child(
      std::in_place,
      std::vector<std::string>{"/bin/sh", "-c",
                               "trap '' TERM; echo $$ > pid; while :; do sleep 1; done"},
      folder.path());
  const int stubborn = pid_in(folder.path() / "pid");
  child.reset();
  EXPECT_FALSE(runs(stubborn));
}

// SIGKILL leaves its victim no time to stop anything: the kernel has to tell the child.
TEST_F(Child, DiesWhenItsParentIsKilled) {
  const int parent = ::fork();
  if (parent == 0) {
    const ChildProcess child(sleeping_shell, folder.path());
    ::pause();
    ::_exit(1);
  }
  const int sleep = pid_in(folder.path() / "pid");
  ASSERT_TRUE(runs(sleep));
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(comes_true([&] { return !runs(sleep); }));
}

TEST_F(Child, ThatIsNoProgramIsAnExternalProgramError) {
  put_text(folder.path() / "text", "no program");
  const auto start = [&](const std::string& program) {
    return failure_of<ExternalProgramError>([&] { ChildProcess({program}, folder.path()); });
  };
  EXPECT_THAT(start("/nowhere/liggghts"),
              HasSubstr("/nowhere/liggghts cannot be started: No such"));
  EXPECT_THAT(start((folder.path() / "text").string()), HasSubstr("Permission denied"));
  EXPECT_THAT(failure_of<ExternalProgramError>(
                  [&] { ChildProcess({"/bin/true"}, folder.path() / "none"); }),
              HasSubstr("No such file"));
}

TEST_F(Child, ThatIsMissingIsNamedWithItsPackage) {
  EXPECT_EQ(program_on_path("sh", "dash").filename(), "sh");
  EXPECT_THAT(failure_of<ExternalProgramError>(
                  [] { static_cast<void>(program_on_path("no_such_mill", "mill-tools")); }),
              HasSubstr("no_such_mill is not on PATH; install the Debian package `mill-tools`"));
}

// Runs in a process of its own, since a noted signal stays noted.
TEST(Interrupts, AreNotedAndThrownWhereTheyAreAskedFor) {
  EXPECT_EXIT(
      {
        note_interrupts();
        stop_if_interrupted();
        ::raise(SIGTERM);
        try {
          stop_if_interrupted();
        } catch (const Interrupted& interrupted) {
          ::_exit(interrupted.signal);
        }
        ::_exit(0);
      },
      testing::ExitedWithCode(SIGTERM), "");
}

}  // namespace
}  // namespace millwear::orchestrator
