#pragma once
#include <string>
#include <string_view>

#include "mill/case_keys/case_document.h"

namespace millwear {

/// A key of a case file by its dotted name: `mill.rows`, `charge.distributions[ore].size_m`,
/// `pairs[steel,ore].restitution`, `materials[steel].density_kg_per_m3`, `wear.mechanisms[0].law`.
/// What stands in brackets picks one of the tables of a name: by `name`, by `material` or by
/// `materials`, or by its number from 0.
struct CaseKeyPath {
  std::string table;
  std::string which;  ///< what stands in brackets; empty for none
  std::string key;
};

/// Reads a dotted name. Throws InputError, with the nearest key, where no case file has such a key,
/// or where brackets are missing or idle.
[[nodiscard]] CaseKeyPath case_key_path(std::string_view dotted);

/// The document with another value of a key, or with the key added to its table. The value keeps
/// the line that it has. Throws InputError where the document has no such table.
[[nodiscard]] CaseDocument with_value(CaseDocument document, const CaseKeyPath& path,
                                      CaseValue value);

/// A value as a command line or a table has it: true, false, a number, or else a text.
[[nodiscard]] CaseValue value_from_text(std::string_view text, int line);

/// The document without a key, which may be missing.
[[nodiscard]] CaseDocument without_key(CaseDocument document, std::string_view table,
                                       std::string_view key);

}  // namespace millwear
