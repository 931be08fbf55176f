#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace millwear::crash {

/// How a program ended: its exit code, or 128 + the signal that ended it, and what it printed.
struct Ended {
  int code;
  std::string out;
  std::string err;
};

/// What a program finds around it.
struct Surroundings {
  std::optional<std::string> path{};  ///< PATH, where it is not this test's own
  std::optional<std::filesystem::path> standard_output{};  ///< in place of Ended::out
  bool without_standard_error = false;
};

/// A millwear that runs beside the test; killed with this object.
class MillwearProcess {
 public:
  explicit MillwearProcess(const std::vector<std::string>& words, const Surroundings& around = {});
  ~MillwearProcess();
  MillwearProcess(const MillwearProcess&) = delete;
  MillwearProcess& operator=(const MillwearProcess&) = delete;

  [[nodiscard]] int pid() const { return pid_; }
  void send(int signal) const;
  /// Waits until `seen` holds or the process has ended; whether `seen` held.
  bool wait_until(const std::function<bool()>& seen);
  [[nodiscard]] Ended wait();

 private:
  bool has_ended();

  std::filesystem::path printed_;
  int pid_;
  std::optional<int> status_;
};

/// Runs millwear to its end.
[[nodiscard]] Ended millwear(const std::vector<std::string>& words,
                             const Surroundings& around = {});

/// Processes that work in a folder or under it, whether or not it has been removed since.
[[nodiscard]] std::vector<int> processes_in(const std::filesystem::path& folder);
/// The same, but waits some seconds for them to go.
[[nodiscard]] std::vector<int> survivors_in(const std::filesystem::path& folder);

}  // namespace millwear::crash
