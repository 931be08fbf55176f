#include "mill/base/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

#include "mill/base/constants.h"
#include "mill/base/failure.h"

namespace millwear {
namespace {

[[noreturn]] void reject(const std::filesystem::path& path, int line, const std::string& what) {
  throw ResultRejected(fmt::format("{}:{}: {}", path.string(), line, what));
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> fields;
  for (;;) {
    const auto comma = text.find(',');
    fields.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    text.remove_prefix(comma + 1);
  }
}

void expect_line(std::istream& file, const std::filesystem::path& path, int number,
                 std::string_view wanted) {
  std::string line;
  std::getline(file, line);
  if (line != wanted)
    reject(
        path, number,
        fmt::format("the line is `{}` where this version reads `{}`; move the run folder away and "
                    "run again, or use the version that wrote it",
                    line.substr(0, 200), wanted));
}

}  // namespace

std::string csv_head(const CsvFormat& format) {
  return fmt::format("# {}\n{}\n", format.name_and_version, format.columns);
}

std::vector<CsvLine> read_csv(const std::filesystem::path& path, const CsvFormat& format) {
  std::ifstream file(path);
  if (!file) throw DiskError(fmt::format("{}: cannot be read", path.string()));
  expect_line(file, path, 1, fmt::format("# {}", format.name_and_version));
  expect_line(file, path, 2, format.columns);
  const auto columns = static_cast<std::size_t>(std::ranges::count(format.columns, ',')) + 1;

  std::vector<CsvLine> lines;
  std::string text;
  for (int number = 3; std::getline(file, text); ++number) {
    lines.push_back({number, split(text)});
    if (const auto found = lines.back().fields.size(); found != columns)
      reject(path, number, fmt::format("{} fields where {} columns are named", found, columns));
  }
  if (file.bad()) throw DiskError(fmt::format("{}: cannot be read to its end", path.string()));
  return lines;
}

std::string csv_number(double value) {
  return std::isnan(value) ? std::string() : fmt::format("{}", value);
}

std::string csv_degrees(double angle) {
  return std::isnan(angle) ? std::string() : fmt::format("{:.14g}", angle * degrees_per_radian);
}

template <class Number>
Number CsvFields::parsed(std::string_view kind) {
  const std::string& text = line_.fields.at(next_++);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    reject(path_, line_.number, fmt::format("`{}` in column {} is not {}", text, next_, kind));
  return value;
}

int CsvFields::integer() { return parsed<int>("a whole number"); }

double CsvFields::number() {
  if (line_.fields.at(next_).empty()) {
    ++next_;
    return std::numeric_limits<double>::quiet_NaN();
  }
  return parsed<double>("a number");
}

double CsvFields::degrees() { return number() / degrees_per_radian; }

const std::string& CsvFields::text() { return line_.fields.at(next_++); }

std::size_t CsvFields::one_of(std::span<const std::string_view> words) {
  const std::string& word = text();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    reject(path_, line_.number,
           fmt::format("`{}` in column {} is none of: {}", word, next_, fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

std::string csv_lengths(const Eigen::VectorXd& lengths) {
  std::string text;
  for (const double length : lengths)
    fmt::format_to(std::back_inserter(text), "{}{:.6f}", text.empty() ? "" : " ", length);
  return text;
}

Eigen::VectorXd CsvFields::lengths() {
  const std::string& text = this->text();
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at < end) {
    const auto [after, error] = std::from_chars(at, end, numbers.emplace_back());
    if (error != std::errc() || (after < end && *after != ' ')) return {};
    at = after < end ? after + 1 : end;
  }
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace millwear
