// Holds the predicted standard errors of campaigns that differ in the seed against their scatter:
//   coverage_table FOLDER              of the campaigns that are kept there
//   coverage_table FOLDER RUN RUN...   of run folders, and keeps them there
#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "orchestrator/study/coverage.h"

int main(int argc, char** argv) {
  using namespace millwear::orchestrator;
  if (argc < 2) {
    fmt::print(stderr, "usage: coverage_table FOLDER [RUN...]\n");
    return 2;
  }
  const std::filesystem::path kept = argv[1];
  if (argc > 2) write_seeds(kept, seeds_of_runs({argv + 2, argv + argc}));
  const Seeds seeds = read_seeds(kept);
  fmt::print("{}", coverage_text(coverage_of(seeds), seeds.lives.size()));
}
