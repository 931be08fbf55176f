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

/// Reads a text dump as it comes, in pieces of any size; holds one snapshot and one unfinished
/// line, however long the run.
class SnapshotReader {
 public:
  using Take = std::function<void(const Snapshot&)>;

  /// `name` stands in messages; `columns` is what every row must have.
  SnapshotReader(std::string name, std::size_t columns, Take take);

  /// Takes the next piece and hands every snapshot that is now complete to `take`.
  /// Throws ResultRejected, with name and line, on a row that is short, long or not finite, and on
  /// a header that is not LIGGGHTS's.
  void feed(std::string_view piece);

  /// The end of the dump. Throws ResultRejected if it ends inside a snapshot.
  void finish() const;

 private:
  enum class Expect { step_header, step, count_header, count, box_header, box, columns, rows };

  void take_line(std::string_view line);
  void take_row(std::string_view line);
  void expect_header(std::string_view line, std::string_view header, Expect next);
  void complete();
  [[noreturn]] void reject(const std::string& why) const;

  std::string name_;
  Take take_;
  std::string unfinished_;
  Snapshot snapshot_;
  Expect expect_ = Expect::step_header;
  std::size_t rows_left_ = 0;
  int box_lines_left_ = 0;
  long line_ = 0;
};

}  // namespace millwear::liggghts
