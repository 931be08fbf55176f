#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// Open files in the place of a program's standard streams, as file descriptors.
struct ChildFiles {
  int input;
  int output;
  int messages;
};

/// A running program in a process group of its own. The group dies with this object, and with this
/// process however that ends.
class ChildProcess {
 public:
  /// Runs the program without input and with standard output and error in one pipe; or on `files`,
  /// then without a pipe. Throws ExternalProgramError if the program cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& folder,
               const std::optional<ChildFiles>& files = {});
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The pipe's end, non-blocking.
  [[nodiscard]] int output() const { return output_; }

  /// Waits for the end; the exit code, or 128 + signal.
  [[nodiscard]] int wait();

  /// The same where it has ended already; nothing where it still runs.
  [[nodiscard]] std::optional<int> ended();

 private:
  void close_output() const;

  int pid_;
  int output_ = -1;
  bool ended_ = false;
};

/// Where a program is on PATH. Throws ExternalProgramError, naming the Debian package that has it
/// (empty where none does).
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
