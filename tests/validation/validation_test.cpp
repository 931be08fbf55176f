#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mill/case_file/case_file.h"
#include "orchestrator/validation/validation_table.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> experiments() {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(fs::path(MILLWEAR_CASES) / "validation"))
    if (entry.is_directory()) folders.push_back(entry.path());
  std::ranges::sort(folders);
  return folders;
}

class Experiment : public testing::TestWithParam<fs::path> {};

// The page says of every number where it comes from.
TEST_P(Experiment, HasASourceForEveryNumberOfItsCase) {
  std::ifstream stream(GetParam() / "case.toml");
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    const auto equals = line.find(" = ");
    const bool is_number = equals != std::string::npos && line.front() != '#' &&
                           line.find_first_of("0123456789", equals) < line.find('#') &&
                           !line.starts_with("format_version");
    if (is_number) {
      EXPECT_NE(line.find("  # "), std::string::npos) << line_number << ": " << line;
    }
  }
}

TEST_P(Experiment, IsKeptWithAFigureForEveryPublishedOne) {
  const Validation kept = kept_validation(GetParam());
  ASSERT_FALSE(kept.published.empty());
  for (const PublishedFigure& published : kept.published) {
    SCOPED_TRACE(name_of(published.quantity).key);
    ASSERT_TRUE(kept.simulated.contains(published.quantity));
    EXPECT_TRUE(std::isfinite(kept.simulated.at(published.quantity).value));
  }
}

// One load, but for an experiment on worn liners.
TEST_P(Experiment, IsACaseThatRuns) {
  const Case mill = read_case(GetParam() / "case.toml");
  EXPECT_EQ(mill.name, GetParam().filename().string());
  const auto published = read_published_figures(GetParam() / "published.csv");
  const bool is_worn = std::ranges::any_of(
      published, [](const PublishedFigure& one) { return one.lifter_height.has_value(); });
  EXPECT_TRUE(is_worn || mill.campaign.cycle_limit == 1);
}

INSTANTIATE_TEST_SUITE_P(Published, Experiment, testing::ValuesIn(experiments()),
                         [](const auto& folder) { return folder.param.filename().string(); });

}  // namespace
}  // namespace millwear::orchestrator
