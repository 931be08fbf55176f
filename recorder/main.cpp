#include <fmt/format.h>
#include <liggghts/input.h>
#include <liggghts/lammps.h>
#include <liggghts/signal_handling.h>
#include <liggghts/universe.h>
#include <mpi.h>

#include <algorithm>
#include <array>
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
#include "recorder/build_check.h"
#include "recorder/collision_spool.h"
#include "recorder/deck_lines.h"
#include "recorder/leak_check.h"
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

/// Commands with which a deck does not run from its top to its bottom on one LIGGGHTS.
bool leaves_the_way(std::string_view command) {
  constexpr std::array<std::string_view, 7> commands = {"clear", "if",   "jump",     "label",
                                                        "next",  "quit", "partition"};
  return std::ranges::find(commands, command) != commands.end();
}

void check_folder_of(const std::filesystem::path& file) {
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw DiskError(
        fmt::format("{}: there is no folder {} to write it into", file.string(), folder.string()));
}

/// What an earlier recording left must not be taken for the result of one that fails.
void remove_old_results(const RecordingPlan& plan) {
  check_folder_of(plan.load);
  if (plan.events) check_folder_of(*plan.events);
  int rank = 0;
  int ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (rank != 0) return;
  std::filesystem::remove(plan.load);
  if (plan.events) remove_old_collisions(*plan.events, ranks);
}

/// LIGGGHTS on a deck, line by line, with the recorder hung in before the first run.
class RecordedDeck {
 public:
  explicit RecordedDeck(const RecordingPlan& plan)
      : plan_(plan), mill_(read_case(plan.mill)), liggghts_(start_liggghts()) {
    check_build(liggghts_build, liggghts_->universe->version);
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
      else if (leaves_the_way(command))
        throw InputError(fmt::format(
            "{}: `{}`: the recorder runs a deck from top to bottom; write the deck without `{}`, "
            "or set wall_contacts = \"dumps\"",
            file.string(), line, command));
      else
        run_line(line);
    }
  }

  void run_line(const std::string& line) {
    if (command_of(line) == "run") {
      if (!recorder_) begin_to_record();
      recorder_->before_run();
    }
    liggghts_->input->one(line.c_str());
    if (command_of(line) == "run") go_on();
  }

  /// Set up anew, LIGGGHTS would order its neighbours anew and end in other bits than one long run.
  void go_on() {
    for (long steps = recorder_->steps_to_go_on(); steps > 0; steps = recorder_->steps_to_go_on())
      liggghts_->input->one(fmt::format("run {} pre no post no", steps).c_str());
  }

  void begin_to_record() {
    try {
      recorder_.emplace(*liggghts_, mill_, plan_);
    } catch (const InputError& problem) {
      throw InputError(
          fmt::format("{} with {}: {}", plan_.deck.string(), plan_.mill.string(), problem.what()));
    }
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
  {
    const UncheckedForLeaks within_mpi;
    MPI_Init(&argc, &argv);
  }
  try {
    const RecordingPlan plan = recording_plan(arguments);
    remove_old_results(plan);
    RecordedDeck(plan).run();
  } catch (const Failure& failure) {
    give_up(failure.what(), failure.exit_code);
  } catch (const std::exception& problem) {
    give_up(fmt::format("internal error: {}", problem.what()), ExitCode::internal);
  }
  check_for_leaks();
  MPI_Finalize();
}
