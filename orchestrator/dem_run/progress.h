#pragma once
#include <chrono>
#include <optional>
#include <string>

namespace millwear::orchestrator {

enum class Verbosity { quiet, normal, verbose };

/// What the user sees while a campaign runs: on a terminal a bar with the time left, elsewhere a
/// line now and then. Everything goes to standard error.
class Progress {
 public:
  /// `line_interval`: between the lines, where there is no terminal.
  explicit Progress(Verbosity verbosity,
                    std::chrono::seconds line_interval = std::chrono::seconds(60));
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A line of its own, e.g. what a stage gave.
  void say(const std::string& line);
  /// The same, for those who asked for details.
  void detail(const std::string& line);

  /// Begins a piece of work that takes the campaign from one share of its whole to another, 0
  /// ... 1.
  void begin(const std::string& what, double share_before, double share_after);
  /// That piece goes by another name from here on.
  void rename(const std::string& what);
  /// How much of that piece is done, 0 ... 1.
  void advance(double done);
  /// The piece is done.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  /// The first piece that takes the campaign on.
  struct Start {
    Clock::time_point time;
    double share;
  };

  void draw();
  void clear_bar();
  [[nodiscard]] std::string time_left() const;

  Verbosity verbosity_;
  std::chrono::seconds line_interval_;
  bool terminal_;
  bool colour_;
  bool bar_shown_ = false;
  std::string what_;
  double share_before_ = 0.0;
  double share_after_ = 0.0;
  double done_ = 0.0;
  std::optional<Start> start_;
  Clock::time_point drawn_{};
};

/// "1 h 05 min", "3 min 20 s", "12 s".
[[nodiscard]] std::string spoken_time(double seconds);

}  // namespace millwear::orchestrator
