#include "mill/base/whole_file.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "mill/base/failure.h"

namespace millwear {

void write_file(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw DiskError(fmt::format("{}: cannot be written; is the disk full?", file.string()));
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  if (!in) throw DiskError(fmt::format("{}: cannot be read", file.string()));
  return text.str();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
    throw DiskError(
        fmt::format("{}: no folder can be made here ({}); give another folder, "
                    "of a campaign with --out",
                    folder.string(), problem.message()));
}

}  // namespace millwear
