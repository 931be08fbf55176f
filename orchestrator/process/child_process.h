#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// A running program in a process group of its own, its standard output and error in one pipe.
/// The group dies with this object, and with this process however that ends.
class ChildProcess {
 public:
  /// Throws ExternalProgramError if the program cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& folder);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] int output() const { return output_; }  ///< file descriptor, non-blocking

  /// Waits for the end; the exit code, or 128 + signal.
  [[nodiscard]] int wait();

 private:
  int pid_;
  int output_;
  bool ended_ = false;
};

/// Where a program is on PATH. Throws ExternalProgramError, naming the Debian package that has it.
[[nodiscard]] std::filesystem::path program_on_path(const std::string& name,
                                                    const std::string& package);

/// Thrown where the user asked the program to stop: exit code 128 + signal.
struct Interrupted {
  int signal;
};

/// From now on SIGINT and SIGTERM are noted instead of ending the process.
void note_interrupts();
/// Throws Interrupted if one has come.
void stop_if_interrupted();

}  // namespace millwear::orchestrator
