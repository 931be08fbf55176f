#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace millwear::liggghts {

/// One instant of a text dump (`dump local` or `dump custom`): rows x columns numbers.
struct Snapshot {
  long step = 0;
  std::size_t columns = 0;
  std::vector<double> values;  ///< row by row

  [[nodiscard]] std::size_t rows() const { return values.size() / columns; }
  [[nodiscard]] std::span<const double> row(std::size_t i) const {
    return {values.data() + i * columns, columns};
  }
};

/// Which columns of a dump are wanted, in the order in which they are wanted.
struct ChosenColumns {
  std::vector<std::size_t> columns;  ///< counted from 0
  std::string problem{};             ///< why they cannot be chosen; empty if they can
};

/// Chooses columns by the names in a dump's header.
using ChooseColumns = std::function<ChosenColumns(std::span<const std::string_view> names)>;

/// Reads a text dump as it comes, in pieces of any size; holds one snapshot and one unfinished
/// line, however long the run.
class SnapshotReader {
 public:
  using Take = std::function<void(const Snapshot&)>;

  /// `name` stands in messages; `columns` is what every row must have.
  SnapshotReader(std::string name, std::size_t columns, Take take);

  /// Reads the columns that `choose` finds in the header; a row has as many as the header names.
  SnapshotReader(std::string name, ChooseColumns choose, Take take);

  /// Takes the next piece and hands every snapshot that is now complete to `take`.
  /// Throws ResultRejected, with name and line, on a row that is short, long or not finite, on a
  /// header that is not LIGGGHTS's or lacks a column, and on a step that is not after the last one.
  void feed(std::string_view piece);

  /// The end of the dump. Throws ResultRejected if it ends inside a snapshot.
  void finish() const;

 private:
  enum class Expect { step_header, step, count_header, count, box_header, box, columns, rows };

  void take_line(std::string_view line);
  void take_row(std::string_view line);
  void take_step(std::string_view line);
  void take_columns(std::string_view line);
  void expect_header(std::string_view line, std::string_view header, Expect next);
  void complete();
  [[noreturn]] void reject_no_whole_number(std::string_view line) const;
  [[noreturn]] void reject(const std::string& why) const;

  std::string name_;
  ChooseColumns choose_;  ///< empty: every column is wanted
  std::string columns_header_;
  std::vector<std::size_t> chosen_;
  std::vector<double> row_;  ///< all columns of one row, where some are chosen
  std::size_t row_columns_;
  Take take_;
  std::string unfinished_;
  Snapshot snapshot_;
  Expect expect_ = Expect::step_header;
  std::size_t rows_left_ = 0;
  int box_lines_left_ = 0;
  long line_ = 0;
  bool is_after_the_first_ = false;
};

}  // namespace millwear::liggghts
