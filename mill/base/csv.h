#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace millwear {

/// What the two first lines of a table must be: `# NAME VERSION` and the names of its columns.
struct CsvFormat {
  std::string_view name_and_version;
  std::string_view columns;  ///< separated by commas
};

/// A row as it stands in the file, with the number of its line (from 1).
struct CsvLine {
  int number;
  std::vector<std::string> fields;
};

/// The two first lines of a file of this format.
[[nodiscard]] std::string csv_head(const CsvFormat& format);

/// The rows of the file, each with as many fields as the format has columns. Throws DiskError where
/// it cannot be read and ResultRejected (file:line) where its version, columns or a row differ.
[[nodiscard]] std::vector<CsvLine> read_csv(const std::filesystem::path& path,
                                            const CsvFormat& format);

/// The shortest text that reads back as the same number; empty for NaN.
[[nodiscard]] std::string csv_number(double value);

/// An angle [rad] in degrees with 14 digits, so that reading and writing again changes no byte.
[[nodiscard]] std::string csv_degrees(double angle);

/// Lengths [m] separated by blanks, to a thousandth of a millimetre.
[[nodiscard]] std::string csv_lengths(const Eigen::VectorXd& lengths);

/// The fields of a row one after the other. Each call throws ResultRejected (file:line, column)
/// where the text is no such number.
class CsvFields {
 public:
  CsvFields(const std::filesystem::path& path, const CsvLine& line) : path_(path), line_(line) {}
  [[nodiscard]] int integer();
  [[nodiscard]] double number();   ///< NaN where the field is empty
  [[nodiscard]] double degrees();  ///< an angle written in degrees [rad]
  [[nodiscard]] const std::string& text();
  [[nodiscard]] Eigen::VectorXd lengths();  ///< of `csv_lengths`; none where one is no number
  /// Which of the words it is; throws for any other.
  [[nodiscard]] std::size_t one_of(std::span<const std::string_view> words);

 private:
  template <class Number>
  Number parsed(std::string_view kind);

  const std::filesystem::path& path_;
  const CsvLine& line_;
  std::size_t next_ = 0;
};

}  // namespace millwear
