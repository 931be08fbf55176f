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
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "liggghts_build.h"
#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "recorder/balance/balanced_columns.h"
#include "recorder/neighbours/neighbours_by_size.h"
#include "recorder/options/mixing_options.h"
#include "recorder/options/recording_plan.h"
#include "recorder/options/run_options.h"
#include "recorder/pairs/touching_pairs.h"
#include "recorder/record/collision_spool.h"
#include "recorder/record/stretch_recorder.h"
#include "recorder/run/build_check.h"
#include "recorder/run/deck_run.h"
#include "recorder/run/leak_check.h"
#include "recorder/run/steady_mixing_run.h"
#include "recorder/turning/turning_mesh.h"
#include "recorder/walls/near_walls.h"

namespace {

using namespace millwear;
using namespace millwear::recorder;

std::unique_ptr<LAMMPS_NS::LAMMPS> start_liggghts() {
  std::vector<std::string> words = {"liggghts", "-log", "none"};
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  auto liggghts = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arguments.size()),
                                                      arguments.data(), MPI_COMM_WORLD);
  check_build(liggghts_build, liggghts->universe->version);
  find_neighbours_by_size(*liggghts);
  compute_only_touching_pairs(*liggghts);
  turn_meshes_by_vectors(*liggghts);
  look_only_near_walls(*liggghts);
  return liggghts;
}

void check_folder_of(const std::filesystem::path& file) {
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw DiskError(
        fmt::format("{}: there is no folder {} to write it into", file.string(), folder.string()));
}

bool is_first_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}

/// What an earlier recording left must not be taken for the result of one that fails.
void remove_old_results(const RecordingPlan& plan) {
  check_folder_of(plan.load);
  if (plan.events) check_folder_of(*plan.events);
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (!is_first_rank()) return;
  std::filesystem::remove(plan.load);
  if (plan.events) remove_old_collisions(*plan.events, ranks);
}

/// LIGGGHTS on a deck, line by line, with the recorder hung in before the first run.
class RecordedDeck {
 public:
  explicit RecordedDeck(const RecordingPlan& plan)
      : plan_(plan), mill_(read_case(plan.mill)), liggghts_(start_liggghts()) {}

  void run() {
    run_deck(*liggghts_, plan_.deck, [this](const std::string& line) { run_line(line); });
    if (!recorder_) throw InputError(plan_.deck.string() + ": the deck has no `run`");
    recorder_->publish();
  }

 private:
  void run_line(const std::string& line) {
    balance_columns(*liggghts_, plan_.columns);
    if (!recorder_) begin_to_record();
    recorder_->before_run();
    liggghts_->input->one(line.c_str());
    go_on();
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

void record(const std::vector<std::string>& arguments) {
  const RecordingPlan plan = recording_plan(arguments);
  remove_old_results(plan);
  RecordedDeck(plan).run();
}

void mix(const std::vector<std::string>& arguments) {
  const MixingOptions options = mixing_options(arguments);
  check_folder_of(options.record);
  if (is_first_rank()) std::filesystem::remove(options.record);
  mix_until_steady(*start_liggghts(), options);
}

void only_run(const std::vector<std::string>& arguments) {
  const DeckRunOptions options = run_options(arguments);
  const auto liggghts = start_liggghts();
  run_deck(*liggghts, options.deck, [&](const std::string& line) {
    balance_columns(*liggghts, options.columns);
    liggghts->input->one(line.c_str());
  });
}

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

/// What the program does with the words behind a verb, and what it says of it.
struct Verb {
  std::string_view name;  ///< none: it records
  void (*act)(const std::vector<std::string>& arguments);
  std::string (*help)();
};

constexpr Verb recording = {"", record, recording_help};
constexpr std::array<Verb, 2> named_verbs = {
    {{mixing_verb, mix, mixing_help}, {running_verb, only_run, run_help}}};

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  Verb verb = recording;
  if (!arguments.empty())
    if (const auto named = std::ranges::find(named_verbs, arguments.front(), &Verb::name);
        named != named_verbs.end()) {
      verb = *named;
      arguments.erase(arguments.begin());
    }
  if (!arguments.empty() && arguments.back() == "--help") {
    fmt::print("{}", verb.help());
    return 0;
  }
  heed_signals();
  {
    const UncheckedForLeaks within_mpi;
    MPI_Init(&argc, &argv);
  }
  try {
    verb.act(arguments);
  } catch (const Failure& failure) {
    give_up(failure.what(), failure.exit_code);
  } catch (const std::exception& problem) {
    give_up(fmt::format("internal error: {}", problem.what()), ExitCode::internal);
  }
  check_for_leaks();
  MPI_Finalize();
}
