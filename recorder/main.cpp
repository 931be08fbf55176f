#include <fmt/format.h>
#include <liggghts/input.h>
#include <liggghts/lammps.h>
#include <liggghts/signal_handling.h>
#include <liggghts/universe.h>
#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "liggghts_build.h"
#include "mill/case_file.h"
#include "mill/failure.h"
#include "recorder/deck_lines.h"
#include "recorder/recording_plan.h"
#include "recorder/stretch_recorder.h"

namespace {

using namespace millwear;
using namespace millwear::recorder;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string() + ": there is no such deck");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::unique_ptr<LAMMPS_NS::LAMMPS> start_liggghts() {
  std::vector<std::string> words = {"liggghts", "-log", "none"};
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  return std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()), arguments.data(),
                                             MPI_COMM_WORLD);
}

void check_build(const LAMMPS_NS::LAMMPS& liggghts) {
  const std::string running = liggghts.universe->version;
  if (running.find(liggghts_build) == std::string::npos)
    throw ExternalProgramError(
        fmt::format("millwear-recorder was built for {}, and this is {}; build it again (make "
                    "build), or set wall_contacts = \"dumps\"",
                    liggghts_build, running));
}

/// LIGGGHTS on a deck, line by line, with the recorder hung in before the first run.
class RecordedDeck {
 public:
  explicit RecordedDeck(const RecordingPlan& plan)
      : plan_(plan), mill_(read_case(plan.mill)), liggghts_(start_liggghts()) {
    check_build(*liggghts_);
  }

  void run() {
    run_file(plan_.deck);
    if (!recorder_) throw InputError(plan_.deck.string() + ": the deck has no `run`");
    recorder_->publish();
  }

 private:
  void run_file(const std::filesystem::path& file) {
    for (const auto& line : deck_lines(text_of(file))) {
      const auto command = command_of(line);
      if (command == "include")
        run_file(argument_of(line));
      else if (command == "jump" || command == "label" || command == "next")
        throw InputError(
            fmt::format("{}: `{}`: the recorder runs a deck from top to bottom; write "
                        "the deck without jumps, or set wall_contacts = \"dumps\"",
                        file.string(), line));
      else
        run_line(line);
    }
  }

  void run_line(const std::string& line) {
    if (command_of(line) == "run") {
      if (!recorder_) recorder_.emplace(*liggghts_, mill_, plan_);
      recorder_->before_run();
    }
    liggghts_->input->one(line.c_str());
  }

  RecordingPlan plan_;
  Case mill_;
  std::unique_ptr<LAMMPS_NS::LAMMPS> liggghts_;
  std::optional<StretchRecorder> recorder_;
};

/// Like LIGGGHTS itself: a run that is told to stop ends with its step.
void heed_signals() {
  struct sigaction action = {};
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

[[noreturn]] void give_up(const std::string& why, ExitCode code) {
  fmt::print("ERROR: {}\n", why);
  std::fflush(stdout);
  MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
  std::abort();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments == std::vector<std::string>{"--help"}) {
    fmt::print("{}", recording_help());
    return 0;
  }
  heed_signals();
  MPI_Init(&argc, &argv);
  try {
    RecordedDeck(recording_plan(arguments)).run();
  } catch (const Failure& failure) {
    give_up(failure.what(), failure.exit_code);
  } catch (const std::exception& problem) {
    give_up(fmt::format("internal error: {}", problem.what()), ExitCode::internal);
  }
  MPI_Finalize();
}
