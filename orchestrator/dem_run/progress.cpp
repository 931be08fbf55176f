#include "orchestrator/dem_run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace millwear::orchestrator {
namespace {

constexpr int bar_width = 24;
constexpr auto bar_interval = std::chrono::milliseconds(200);

std::string bar(double share, bool colour) {
  const int full = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * bar_width));
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += i < full ? "█" : "·";
  return colour ? "\033[36m" + text + "\033[0m" : text;
}

}  // namespace

std::string spoken_time(double seconds) {
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

Progress::Progress(Verbosity verbosity, std::chrono::seconds line_interval)
    : verbosity_(verbosity),
      line_interval_(line_interval),
      terminal_(::isatty(STDERR_FILENO) == 1),
      colour_(terminal_ && std::getenv("NO_COLOR") == nullptr) {}

Progress::~Progress() { clear_bar(); }

void Progress::say(const std::string& line) {
  if (verbosity_ == Verbosity::quiet) return;
  clear_bar();
  fmt::print(stderr, "{}\n", line);
}

void Progress::detail(const std::string& line) {
  if (verbosity_ == Verbosity::verbose) say(line);
}

void Progress::begin(const std::string& what, double share_before, double share_after) {
  what_ = what;
  share_before_ = share_before;
  share_after_ = share_after;
  done_ = 0.0;
  if (!start_ && share_after > share_before) start_ = {Clock::now(), share_before};
  drawn_ = Clock::now();
  if (terminal_) draw();
}

void Progress::rename(const std::string& what) { what_ = what; }

void Progress::advance(double done) {
  done_ = std::clamp(done, 0.0, 1.0);
  const auto interval = terminal_ ? Clock::duration(bar_interval) : Clock::duration(line_interval_);
  if (Clock::now() - drawn_ > interval) draw();
}

void Progress::end() { clear_bar(); }

std::string Progress::time_left() const {
  if (!start_) return "";
  const double share = share_before_ + done_ * (share_after_ - share_before_);
  const double gained = share - start_->share;
  if (gained < 0.01) return "";
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_->time).count();
  return fmt::format("  about {} left", spoken_time(elapsed * (1.0 - share) / gained));
}

void Progress::draw() {
  if (verbosity_ == Verbosity::quiet) return;
  drawn_ = Clock::now();
  const double share = share_before_ + done_ * (share_after_ - share_before_);
  if (!terminal_) {
    fmt::print(stderr, "  {}: {:.0f} %{}\n", what_, 100.0 * done_, time_left());
    return;
  }
  fmt::print(stderr, "\r\033[K{} {:3.0f} %  {} ({:.0f} %){}", bar(share, colour_), 100.0 * share,
             what_, 100.0 * done_, time_left());
  std::fflush(stderr);
  bar_shown_ = true;
}

void Progress::clear_bar() {
  if (!bar_shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  bar_shown_ = false;
}

}  // namespace millwear::orchestrator
