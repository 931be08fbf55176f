#include "tests/crash/campaign_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto patience = 10s;

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "millwear_printed_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

[[noreturn]] void become(const std::vector<std::string>& words, const Surroundings& around,
                         const fs::path& printed) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const auto put = [](const fs::path& file, int stream) {
    ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600), stream);
  };
  put(around.standard_output.value_or(printed / "out"), STDOUT_FILENO);
  put(printed / "err", STDERR_FILENO);
  if (around.without_standard_error) ::close(STDERR_FILENO);
  if (around.path) ::setenv("PATH", around.path->c_str(), 1);
  std::vector<char*> argv = {const_cast<char*>(MILLWEAR_PROGRAM)};
  for (const auto& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

}  // namespace

MillwearProcess::MillwearProcess(const std::vector<std::string>& words, const Surroundings& around)
    : printed_(new_folder()), pid_(::fork()) {
  if (pid_ == 0) become(words, around, printed_);
}

MillwearProcess::~MillwearProcess() {
  if (!has_ended()) {
    send(SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  fs::remove_all(printed_);
}

void MillwearProcess::send(int signal) const { ::kill(pid_, signal); }

bool MillwearProcess::has_ended() {
  int status = 0;
  if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_) status_ = status;
  return status_.has_value();
}

bool MillwearProcess::wait_until(const std::function<bool()>& seen) {
  while (!seen()) {
    if (has_ended()) return seen();
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

Ended MillwearProcess::wait() {
  wait_until([] { return false; });
  const int code = WIFEXITED(*status_) ? WEXITSTATUS(*status_) : 128 + WTERMSIG(*status_);
  return {code, text_of(printed_ / "out"), text_of(printed_ / "err")};
}

Ended millwear(const std::vector<std::string>& words, const Surroundings& around) {
  return MillwearProcess(words, around).wait();
}

std::vector<int> processes_in(const fs::path& folder) {
  std::vector<int> found;
  for (const auto& process : fs::directory_iterator("/proc")) {
    const std::string name = process.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::error_code gone;
    const auto works_in = fs::read_symlink(process.path() / "cwd", gone).string();
    if (!gone && works_in.starts_with(folder.string())) found.push_back(std::stoi(name));
  }
  return found;
}

std::vector<int> survivors_in(const fs::path& folder) {
  const auto until = std::chrono::steady_clock::now() + patience;
  auto alive = processes_in(folder);
  while (!alive.empty() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(20ms);
    alive = processes_in(folder);
  }
  return alive;
}

}  // namespace millwear::crash
