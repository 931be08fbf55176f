#include "orchestrator/campaign/lock_holder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>

#include "orchestrator/process/host_name.h"

namespace millwear::orchestrator {
namespace {

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  file >> id;
  return id.empty() ? "unknown" : id;
}

/// Ended, and not yet waited for by its parent.
bool is_zombie(long process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string text;
  std::getline(file, text);
  const auto name_end = text.rfind(')');  // a program's name may have anything in it
  return name_end != std::string::npos && text.compare(name_end + 1, 3, " Z ") == 0;
}

}  // namespace

LockHolder this_process() { return {host_name(), ::getpid(), boot_id()}; }

std::string written(const LockHolder& holder) {
  return fmt::format("{} {} {}\n", holder.host, holder.process, holder.boot);
}

std::optional<LockHolder> lock_holder_from(std::string_view text) {
  std::istringstream stream{std::string(text)};
  LockHolder holder{};
  if (stream >> holder.host >> holder.process >> holder.boot) return holder;
  return std::nullopt;
}

bool is_gone(const LockHolder& holder) {
  const LockHolder here = this_process();
  if (holder.host != here.host) return false;
  if (holder.boot != here.boot) return true;
  if (::kill(static_cast<pid_t>(holder.process), 0) != 0) return errno == ESRCH;
  return is_zombie(holder.process);
}

std::string spoken(const std::optional<LockHolder>& holder) {
  if (!holder) return "another process";
  return fmt::format("process {} on {}", holder->process, holder->host);
}

}  // namespace millwear::orchestrator
