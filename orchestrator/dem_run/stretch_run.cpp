#include "orchestrator/dem_run/stretch_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include "liggghts_inputs/decks/deck.h"
#include "mill/base/failure.h"
#include "mill/recording/recorder_orders.h"
#include "orchestrator/dem_run/launcher.h"
#include "orchestrator/process/child_process.h"

namespace millwear::orchestrator {
namespace {

constexpr std::size_t piece_size = 1 << 18;
constexpr int pipe_capacity = 1 << 20;
constexpr int longest_wait_ms = 500;  // an interrupt that comes just before the wait is seen then

/// The reading end of a named pipe, which is removed with this object.
class NamedPipe {
 public:
  explicit NamedPipe(std::filesystem::path path) : path_(std::move(path)) {
    if (::mkfifo(path_.c_str(), 0600) != 0)
      throw DiskError(fmt::format("{}: no pipe can be made here ({}); set keep_dumps = true",
                                  path_.string(), std::strerror(errno)));
    fd_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ::fcntl(fd_, F_SETPIPE_SZ, pipe_capacity);
  }
  ~NamedPipe() {
    ::close(fd_);
    ::unlink(path_.c_str());
  }
  NamedPipe(NamedPipe&& other) noexcept
      : path_(std::exchange(other.path_, {})), fd_(std::exchange(other.fd_, -1)) {}
  NamedPipe& operator=(NamedPipe&&) = delete;

  [[nodiscard]] int fd() const { return fd_; }

 private:
  std::filesystem::path path_;
  int fd_ = -1;
};

enum class Read { some, nothing_now, end };

Read read_piece(int fd, std::string& buffer, const std::function<void(std::string_view)>& take) {
  buffer.resize(piece_size);
  const ssize_t length = ::read(fd, buffer.data(), buffer.size());
  if (length > 0) {
    take({buffer.data(), static_cast<std::size_t>(length)});
    return Read::some;
  }
  return length == 0 ? Read::end : Read::nothing_now;
}

/// Cuts what LIGGGHTS prints into lines, and keeps all of it in the log.
class PrintedOutput {
 public:
  PrintedOutput(std::filesystem::path log, const std::function<void(std::string_view)>& take_line)
      : path_(std::move(log)), log_(path_, std::ios::binary), take_line_(take_line) {}

  void take(std::string_view piece) {
    log_ << piece << std::flush;
    unfinished_ += piece;
    std::size_t start = 0;
    for (std::size_t end; (end = unfinished_.find('\n', start)) != std::string::npos;
         start = end + 1)
      if (take_line_) take_line_(std::string_view(unfinished_).substr(start, end - start));
    unfinished_.erase(0, start);
  }

  void close() {
    log_.close();
    if (!log_)
      throw DiskError(fmt::format("{}: cannot be written; is the disk full?", path_.string()));
  }

 private:
  std::filesystem::path path_;
  std::ofstream log_;
  const std::function<void(std::string_view)>& take_line_;
  std::string unfinished_;
};

std::vector<std::string> program_of(const StretchRun& run) {
  if (!run.recorder)
    return {program_on_path("liggghts", "liggghts").string(), "-in", liggghts::file_names::deck,
            "-log", "none"};
  std::vector<std::string> words = {run.recorder->program.string()};
  words.insert(words.end(), run.recorder->arguments.begin(), run.recorder->arguments.end());
  return words;
}

}  // namespace

std::filesystem::path recorder_program() {
  const char* const name = "millwear-recorder";
  const auto beside = std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
  if (std::filesystem::exists(beside)) return beside;
  try {
    return program_on_path(name, "");
  } catch (const ExternalProgramError&) {
    throw ExternalProgramError(
        fmt::format("{} is neither beside this program nor on PATH; build it (make build), or set "
                    "wall_contacts = \"dumps\" in [dem] to do with the plain liggghts",
                    name));
  }
}

std::optional<RecorderProgram> unrecorded_program(const Case& mill, int ranks) {
  if (mill.dem.contact_path == ContactPath::dumps) return std::nullopt;
  return RecorderProgram{recorder_program(),
                         to_arguments(DeckRunOptions{liggghts::file_names::deck,
                                                     liggghts::columns_to_balance(mill, ranks)})};
}

void check_liggghts_is_installed(const DemSettings& settings) {
  check_started_once();
  static_cast<void>(launch_words(settings.launcher, 1, {}));
  static_cast<void>(program_on_path("liggghts", "liggghts"));
  if (settings.contact_path == ContactPath::recorder) static_cast<void>(recorder_program());
}

int run_liggghts(const StretchRun& run, const std::vector<DumpPipe>& pipes) {
  const auto command = launch_words(run.launcher, run.ranks, program_of(run));
  std::vector<NamedPipe> ends;
  for (const auto& pipe : pipes) ends.emplace_back(run.folder / pipe.name);
  PrintedOutput printed(run.folder / liggghts::file_names::log, run.take_line);
  ChildProcess child(command, run.folder);

  std::vector<pollfd> waiting = {{child.output(), POLLIN, 0}};
  for (const auto& end : ends) waiting.push_back({end.fd(), POLLIN, 0});
  std::string buffer;
  const auto read_from = [&](std::size_t i) {
    return i == 0 ? read_piece(waiting[0].fd, buffer,
                               [&](std::string_view piece) { printed.take(piece); })
                  : read_piece(waiting[i].fd, buffer, pipes[i - 1].take);
  };
  while (waiting[0].fd >= 0) {
    if (::poll(waiting.data(), waiting.size(), longest_wait_ms) < 0) stop_if_interrupted();
    for (std::size_t i = waiting.size(); i-- > 0;)
      if ((waiting[i].revents & (POLLIN | POLLHUP)) != 0 && read_from(i) == Read::end)
        waiting[i].fd = -1;
    stop_if_interrupted();
  }
  for (std::size_t i = 1; i < waiting.size(); ++i)
    while (waiting[i].fd >= 0 && read_from(i) == Read::some) continue;
  printed.close();
  return child.wait();
}

void read_dump_file(const std::filesystem::path& file,
                    const std::function<void(std::string_view)>& take) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0)
    throw DiskError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  std::string buffer;
  while (read_piece(fd, buffer, take) == Read::some) continue;
  ::close(fd);
}

}  // namespace millwear::orchestrator
