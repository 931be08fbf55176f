#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "mill/base/published_file.h"
#include "orchestrator/report/report.h"
#include "orchestrator/results/gather.h"
#include "orchestrator/results/result_files.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_folder.h"

/// Publishes the results and the report after each of 60 cycles of a campaign without a DEM, and
/// prints
/// the processor time of the first five and of the last five (medians).
int main() {
  namespace orchestrator = millwear::orchestrator;
  const auto now = [] { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  constexpr int cycles = 60;
  const orchestrator::TemporaryFolder place;
  const auto run = orchestrator::synthetic_run(place.path(), cycles);
  const auto& campaign = run.campaign;
  std::vector<double> gathered;
  std::vector<double> published;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const auto ledger = orchestrator::ledger_after(run.ledger, cycle);
    const auto begin = now();
    const auto results = orchestrator::gather(campaign, ledger);
    const auto known = now();
    orchestrator::publish_results(campaign, ledger, results);
    millwear::publish(campaign.folder.report(), orchestrator::report_html(results));
    const auto end = now();
    gathered.push_back(known - begin);
    published.push_back(end - begin);
  }
  const auto print = [](const char* what, const std::vector<double>& times) {
    const auto median_from = [&](auto from) {
      std::vector<double> five(from, from + 5);
      std::ranges::sort(five);
      return five[2];
    };
    const double first = median_from(times.begin());
    const double last = median_from(times.end() - 5);
    fmt::print("{:<34} first {:7.1f} ms   last {:7.1f} ms   ratio {:.2f}\n", what, first, last,
               last / first);
  };
  print("results worked out", gathered);
  print("worked out, written, with report", published);
}
