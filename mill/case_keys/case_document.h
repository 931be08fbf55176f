#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace millwear {

struct CaseValue;
using CaseArray = std::vector<CaseValue>;

/// Something that no key of a case file takes: a date, a table too deep.
struct ForeignValue {
  std::string_view type;
};

/// A value of a case file and the line it stands on.
struct CaseValue {
  int line;
  std::variant<ForeignValue, bool, std::int64_t, double, std::string, CaseArray> data;
};

/// A table of a case file, `[name]` or one of `[[name]]`, with its keys in the order of the file.
struct CaseTable {
  std::string name;  ///< "charge.counts"; empty for the keys before the first table
  int line;
  bool repeated;  ///< written as [[name]]
  std::vector<std::pair<std::string, CaseValue>> keys;

  [[nodiscard]] const CaseValue* find(std::string_view key) const;  ///< or nullptr
};

/// A case file as written, before its keys are looked at.
struct CaseDocument {
  std::filesystem::path file;
  std::vector<CaseTable> tables;

  [[nodiscard]] const CaseTable* find(std::string_view table) const;  ///< the first, or nullptr
  [[nodiscard]] std::vector<const CaseTable*> all(std::string_view table) const;

  /// Line of a key, of its table where the key is missing, 1 where the table is missing.
  [[nodiscard]] int line_of(std::string_view table, std::string_view key) const;
};

/// Reads the text of a case file, which has passed `check_plain_text`.
/// Throws InputError with file and line where it is not TOML.
[[nodiscard]] CaseDocument parse_case_document(std::string_view text,
                                               const std::filesystem::path& file);

}  // namespace millwear
