#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "mill/base/published_file.h"

namespace millwear::orchestrator {

/// The page's elements after its scripts have run in a browser without a window. The fragment
/// stands behind the page's address. See `complaints`.
inline std::string drawn(const std::string& page, const std::filesystem::path& folder,
                         const std::string& fragment = "") {
  std::filesystem::create_directories(folder);
  publish(folder / "report.html", page);
  const std::string command =
      std::string(CHROMIUM) +
      " --headless --no-sandbox --disable-gpu --disable-quic --no-first-run"
      " --disable-background-networking --disable-component-update --disable-sync"
      " --user-data-dir=" +
      (folder / "browser").string() +
      " --window-size=1280,3000 --virtual-time-budget=4000 --enable-logging=stderr --dump-dom "
      "'file://" +
      (folder / "report.html").string() + fragment + "' 2>" + (folder / "browser.log").string();
  const std::unique_ptr<FILE, int (*)(FILE*)> output(::popen(command.c_str(), "r"), ::pclose);
  std::string text;
  std::array<char, 65536> part{};
  while (const auto count = std::fread(part.data(), 1, part.size(), output.get()))
    text.append(part.data(), count);
  return text;
}

/// What `drawn` in the same folder wrote to the browser's console: errors of scripts, and requests
/// that the page's policy forbids.
inline std::vector<std::string> complaints(const std::filesystem::path& folder) {
  std::ifstream log(folder / "browser.log");
  std::vector<std::string> lines;
  for (std::string line; std::getline(log, line);)
    if (line.find(":CONSOLE") != std::string::npos) lines.push_back(line);
  return lines;
}

inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

inline std::string part_between(const std::string& text, const std::string& from,
                                const std::string& to) {
  const auto start = text.find(from);
  return start == std::string::npos ? "" : text.substr(start, text.find(to, start) - start);
}

}  // namespace millwear::orchestrator
