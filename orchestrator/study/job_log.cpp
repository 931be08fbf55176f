#include "orchestrator/study/job_log.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <sstream>
#include <vector>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"

namespace millwear::orchestrator {
namespace {

constexpr std::string_view head = "point\thost\tstart\tseconds\texit\tcommand\n";

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, '\t');) fields.push_back(field);
  return fields;
}

}  // namespace

std::string utc_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

void append_job(const std::filesystem::path& file, const JobRecord& job) {
  const bool is_new = !std::filesystem::exists(file);
  const std::string line =
      fmt::format("{}{}\t{}\t{}\t{:.1f}\t{}\t{}\n", is_new ? head : "", job.point, job.host,
                  job.start, job.seconds, job.exit, job.command);
  const int log = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  const auto size = static_cast<ssize_t>(line.size());
  const bool is_written =
      log >= 0 && ::write(log, line.data(), line.size()) == size && ::fsync(log) == 0;
  const int why = errno;
  if (log >= 0) ::close(log);
  if (!is_written)
    throw DiskError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(why)));
}

std::map<std::string, int> last_exits(const std::filesystem::path& file) {
  std::map<std::string, int> exits;
  if (!std::filesystem::exists(file)) return exits;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) {
    const auto fields = fields_of(line);
    if (fields.size() < 5) continue;
    int code = 0;
    const std::string& word = fields[4];
    if (std::from_chars(word.data(), word.data() + word.size(), code).ec == std::errc{})
      exits[fields[0]] = code;
  }
  return exits;
}

}  // namespace millwear::orchestrator
