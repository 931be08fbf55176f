// Holds simulations of published experiments against what was published:
//   validation_table FOLDER...         a table of the figures that are kept in these folders
//   validation_table --keep FOLDER RUN keeps the figures of a campaign of the folder's case
#include "orchestrator/validation/validation_table.h"

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/case_file/case_file.h"
#include "orchestrator/campaign/open_campaign.h"

namespace {

namespace fs = std::filesystem;
using namespace millwear::orchestrator;

void keep(const fs::path& folder, const fs::path& run) {
  const millwear::Case mill = millwear::read_case(folder / "case.toml");
  const auto opened = campaign_of(mill, RunFolder{run});
  const auto figures =
      simulated_figures(opened.campaign, read_published_figures(folder / "published.csv"));
  millwear::publish(folder / "simulated.csv", simulated_csv(figures));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> told(argv + 1, argv + argc);
  try {
    if (told.size() == 3 && told[0] == "--keep") {
      keep(told[1], told[2]);
      return 0;
    }
    if (told.empty() || told[0].starts_with("-")) {
      fmt::print(stderr, "usage: validation_table FOLDER... | --keep FOLDER RUN\n");
      return 2;
    }
    std::vector<Validation> validations;
    for (const auto& folder : told) validations.push_back(kept_validation(folder));
    fmt::print("{}", validation_table(validations));
  } catch (const millwear::Failure& problem) {
    fmt::print(stderr, "validation_table: {}\n", problem.what());
    return static_cast<int>(problem.exit_code);
  }
}
