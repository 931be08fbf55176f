#include "orchestrator/pictures/gnuplot.h"

#include <fmt/format.h>

#include <filesystem>

#include "mill/base/failure.h"
#include "orchestrator/process/child_process.h"
#include "orchestrator/process/memory_file.h"

namespace millwear::orchestrator {

std::string gnuplot_output(std::string_view commands) {
  // As a file, not on standard input: that gnuplot reads byte by byte.
  const MemoryFile script("a plot", commands);
  const MemoryFile nothing("a plot");
  const MemoryFile output("a plot");
  const MemoryFile messages("a plot");
  ChildProcess gnuplot(
      {program_on_path("gnuplot", "gnuplot-nox").string(), script.path().string()},
      std::filesystem::current_path(),
      ChildFiles{nothing.descriptor(), output.descriptor(), messages.descriptor()});
  if (const int code = gnuplot.wait(); code != 0)
    throw ExternalProgramError(
        fmt::format("gnuplot failed (exit code {}): {}", code, messages.content()));
  return output.content();
}

}  // namespace millwear::orchestrator
