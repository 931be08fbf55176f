#include "liggghts_inputs/outputs/snapshot_reader.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

template <class Number>
Number whole_number(std::string_view line, bool& good) {
  Number value{};
  const auto [end, problem] = std::from_chars(line.data(), line.data() + line.size(), value);
  good = problem == std::errc{} && end == line.data() + line.size();
  return value;
}

}  // namespace

SnapshotReader::SnapshotReader(std::string name, std::size_t columns, Take take)
    : name_(std::move(name)), take_(std::move(take)) {
  snapshot_.columns = columns;
}

void SnapshotReader::feed(std::string_view piece) {
  while (!piece.empty()) {
    const void* const end = std::memchr(piece.data(), '\n', piece.size());
    if (end == nullptr) {
      unfinished_ += piece;
      return;
    }
    const auto length = static_cast<std::size_t>(static_cast<const char*>(end) - piece.data());
    if (unfinished_.empty()) {
      take_line(piece.substr(0, length));
    } else {
      unfinished_ += piece.substr(0, length);
      const std::string line = std::exchange(unfinished_, {});
      take_line(line);
    }
    piece.remove_prefix(length + 1);
  }
}

void SnapshotReader::finish() const {
  if (!unfinished_.empty() || expect_ != Expect::step_header)
    reject(fmt::format("the dump ends inside the snapshot of step {}; it is torn", snapshot_.step));
}

void SnapshotReader::take_line(std::string_view line) {
  ++line_;
  bool good = true;
  switch (expect_) {
    case Expect::rows:
      take_row(line);
      if (--rows_left_ == 0) complete();
      return;
    case Expect::step_header:
      return expect_header(line, "ITEM: TIMESTEP", Expect::step);
    case Expect::step:
      snapshot_.step = whole_number<long>(line, good);
      expect_ = Expect::count_header;
      break;
    case Expect::count_header:
      return expect_header(line, "ITEM: NUMBER OF ", Expect::count);
    case Expect::count:
      rows_left_ = whole_number<std::size_t>(line, good);
      expect_ = Expect::box_header;
      break;
    case Expect::box_header:
      box_lines_left_ = 3;
      return expect_header(line, "ITEM: BOX BOUNDS", Expect::box);
    case Expect::box:
      if (--box_lines_left_ == 0) expect_ = Expect::columns;
      return;
    case Expect::columns:
      expect_header(line, "ITEM: ", Expect::rows);
      snapshot_.values.clear();
      snapshot_.values.reserve(rows_left_ * snapshot_.columns);
      if (rows_left_ == 0) complete();
      return;
  }
  if (!good) reject(fmt::format("a whole number was expected, not \"{}\"", line.substr(0, 80)));
}

void SnapshotReader::take_row(std::string_view line) {
  const char* at = line.data();
  const char* const end = at + line.size();
  for (std::size_t column = 0; column < snapshot_.columns; ++column) {
    while (at != end && *at == ' ') ++at;
    double value = 0.0;
    const auto [next, problem] = std::from_chars(at, end, value);
    const bool ends_here = next == end || *next == ' ';
    if (problem != std::errc{} || !ends_here || !std::isfinite(value))
      reject(fmt::format("column {} of {} is not a finite number in \"{}\"", column + 1,
                         snapshot_.columns, line.substr(0, 120)));
    snapshot_.values.push_back(value);
    at = next;
  }
  while (at != end && *at == ' ') ++at;
  if (at != end)
    reject(fmt::format("a row has more than {} columns: \"{}\"", snapshot_.columns,
                       line.substr(0, 120)));
}

void SnapshotReader::expect_header(std::string_view line, std::string_view header, Expect next) {
  if (!line.starts_with(header))
    reject(fmt::format("\"{}\" was expected, not \"{}\"", header, line.substr(0, 80)));
  expect_ = next;
}

void SnapshotReader::complete() {
  expect_ = Expect::step_header;
  take_(snapshot_);
}

void SnapshotReader::reject(const std::string& why) const {
  throw ResultRejected(fmt::format("{}:{}: {}", name_, line_, why));
}

}  // namespace millwear::liggghts
