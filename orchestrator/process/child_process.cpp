#include "orchestrator/process/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "mill/base/failure.h"

namespace millwear::orchestrator {
namespace {

volatile std::sig_atomic_t interrupt_signal = 0;

constexpr auto patience = std::chrono::seconds(5);

[[noreturn]] void become(char* const* argv, const char* folder, const ChildFiles& files,
                         int problem_pipe, int parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  if (::chdir(folder) == 0 && ::dup2(files.input, STDIN_FILENO) >= 0 &&
      ::dup2(files.output, STDOUT_FILENO) >= 0 && ::dup2(files.messages, STDERR_FILENO) >= 0) {
    // A file that already was the stream keeps its close-on-exec.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      ::fcntl(stream, F_SETFD, 0);
    ::execv(argv[0], argv);
  }
  const int problem = errno;
  [[maybe_unused]] const auto told = ::write(problem_pipe, &problem, sizeof problem);
  ::_exit(127);
}

/// The reading end, then the writing end.
std::array<int, 2> new_pipe(const std::string& program) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw ExternalProgramError(fmt::format("no pipe to {}: {}", program, std::strerror(errno)));
  return ends;
}

int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int no_input() { return ::open("/dev/null", O_RDONLY | O_CLOEXEC); }

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& folder,
                           const std::optional<ChildFiles>& files) {
  const auto problem = new_pipe(command[0]);
  const auto output = files ? std::array{-1, -1} : new_pipe(command[0]);
  const ChildFiles streams = files ? *files : ChildFiles{no_input(), output[1], output[1]};
  std::vector<char*> argv;
  for (const auto& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const std::string folder_text = folder.string();
  const int parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) become(argv.data(), folder_text.c_str(), streams, problem[1], parent);
  int why = errno;
  if (!files) {
    ::close(streams.input);
    ::close(streams.output);
  }
  ::close(problem[1]);
  output_ = output[0];
  const bool failed = pid_ < 0 || ::read(problem[0], &why, sizeof why) == sizeof why;
  ::close(problem[0]);
  if (failed) {
    close_output();
    if (pid_ > 0) ::waitpid(pid_, nullptr, 0);
    throw ExternalProgramError(
        fmt::format("{} cannot be started: {}", command[0], std::strerror(why)));
  }
  if (output_ >= 0) ::fcntl(output_, F_SETFL, O_NONBLOCK);
}

void ChildProcess::close_output() const {
  if (output_ >= 0) ::close(output_);
}

ChildProcess::~ChildProcess() {
  close_output();
  if (ended_) return;
  ::kill(-pid_, SIGTERM);
  const auto until = std::chrono::steady_clock::now() + patience;
  while (::waitpid(pid_, nullptr, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) {
      ::kill(-pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

int ChildProcess::wait() {
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) stop_if_interrupted();
  ended_ = true;
  return exit_code_of(status);
}

std::optional<int> ChildProcess::ended() {
  int status = 0;
  if (::waitpid(pid_, &status, WNOHANG) != pid_) return std::nullopt;
  ended_ = true;
  return exit_code_of(status);
}

std::filesystem::path program_on_path(const std::string& name, const std::string& package) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto candidate = std::filesystem::path(folder) / name;
    if (::access(candidate.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(candidate))
      return candidate;
  }
  throw ExternalProgramError(
      fmt::format("{} is not on PATH{}", name,
                  package.empty() ? ""
                                  : fmt::format("; install the Debian package `{0}` (apt-get "
                                                "install {0})",
                                                package)));
}

void note_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int signal) { interrupt_signal = signal; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

void stop_if_interrupted() {
  if (interrupt_signal != 0) throw Interrupted{interrupt_signal};
}

}  // namespace millwear::orchestrator
