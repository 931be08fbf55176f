#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/results/history.h"
#include "orchestrator/results/profiles.h"
#include "orchestrator/study/job_log.h"
#include "orchestrator/study/run_campaigns.h"
#include "orchestrator/study/study_page.h"
#include "orchestrator/study/study_results.h"
#include "orchestrator/study/study_tables.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int points_on_an_axis = 100;
constexpr int rows_of_history = 60;

/// Prints how long the work since the last call took.
class Stopwatch {
 public:
  void lap(const char* what) {
    const auto now = Clock::now();
    fmt::print("{:<48} {:7.2f} s\n", what, std::chrono::duration<double>(now - begun_).count());
    begun_ = now;
  }

 private:
  Clock::time_point begun_ = Clock::now();
};

Study study_of(const fs::path& case_file) {
  Study study = study_of_case(
      case_file, {fmt::format("lifter.height_m=0.03:0.05:{}", 0.02 / (points_on_an_axis - 1)),
                  fmt::format("mill.speed_rpm=20:30:{}", 10.0 / (points_on_an_axis - 1))});
  study.objective = objective_from("maximise life_hours");
  return study;
}

/// What a campaign leaves, without its DEM: results of as many steps as a long life has.
void leave_results(const fs::path& campaign, const LinerProfile& liner, double life) {
  const fs::path results = campaign / "results";
  make_folder(results);
  std::vector<HistoryRow> rows(rows_of_history);
  std::vector<ProfileRow> profiles;
  for (int i = 0; i < rows_of_history; ++i) {
    const double share = static_cast<double>(i) / (rows_of_history - 1);
    HistoryRow& row = rows[static_cast<std::size_t>(i)];
    row.cycle = i / 5;
    row.operating_hours = share * life;
    row.lifter_height = 0.05 - 0.03 * share;
    row.worn_volume = 0.005 * share;
    row.power = 1e3;
    if (i % 10 == 0)
      profiles.push_back({row.cycle, i % 5, row.operating_hours, liner.nodes,
                          std::vector<double>(liner.nodes.size(), 1e-4)});
  }
  write_file(results / "history.csv", history_csv(rows));
  write_file(results / "profiles.csv", profiles_csv(profiles));
  write_file(results / "summary.json",
             fmt::format("{{\"life_reached\": true, \"life_hours\": {}, \"life_hours_low\": {}, "
                         "\"life_hours_high\": {}, \"life_tonnes\": null, \"cycles\": 0}}",
                         life, 0.97 * life, 1.03 * life));
}

}  // namespace
}  // namespace millwear::orchestrator

/// A study of 10,000 points from its axes to its page, with made-up results in the place of the
/// campaigns.
///     bench_study CASE
int main(int argc, char** argv) {
  using namespace millwear::orchestrator;
  if (argc != 2) return EXIT_FAILURE;
  const TemporaryFolder place;
  const StudyFolder folder{place.path()};
  Stopwatch stopwatch;
  const StudyPlan plan = plan_of(study_of(argv[1]));
  stopwatch.lap(fmt::format("{} points generated and checked", plan.points.size()).c_str());
  const auto folders = folders_of(folder, plan);
  keep_plan(folder, plan, folders);
  link_by_value(folder, plan, folders);
  stopwatch.lap("folders and links made");
  for (std::size_t i = 0; i < folders.size(); ++i)
    leave_results(folders[i], plan.base.liner, 3e4 + static_cast<double>(i));
  std::string log = "point\thost\tstart\tseconds\texit\tcommand\n";
  for (const auto& one : folders) log += one.filename().string() + "\there\tnow\t1\t0\tstub\n";
  millwear::publish(folder.jobs(), log);
  stopwatch.lap("(made-up results written)");
  const auto again = folders_of(folder, plan);
  const auto states = states_of(folder, again);
  stopwatch.lap("checked for what is done");
  const StudyResults results = study_results(plan, again, states);
  stopwatch.lap("results gathered");
  millwear::publish(folder.table(), study_csv(results));
  millwear::publish(folder.json(), study_json(results));
  millwear::publish(folder.page(), study_html(results, {"", ""}));
  stopwatch.lap("tables and page written");
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("largest memory {} MiB, page {} MiB\n", usage.ru_maxrss >> 10,
             fs::file_size(folder.page()) >> 20);
}
