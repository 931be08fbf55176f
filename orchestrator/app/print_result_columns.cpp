#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "orchestrator/app/column_pages.h"

/// Prints a page (docs/file_formats.md) with the tables of columns as they are in the program.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ifstream page(argv[1]);
  fmt::print("{}", millwear::orchestrator::with_column_pages(
                       std::string(std::istreambuf_iterator<char>(page), {})));
}
