#pragma once
#include <filesystem>
#include <string_view>

#include "mill/case/case.h"
#include "mill/case_keys/case_document.h"
#include "mill/liner/drawn_liner.h"

namespace millwear {

/// Reads and checks a case file (docs/case_file.md), a drawn liner by `draw`. Never writes.
/// Throws InputError with all that is wrong, a line each: "file:line: what; what would be right".
[[nodiscard]] Case read_case(const std::filesystem::path& file,
                             const ReadDrawnLiner& draw = no_drawings);

/// The same for a text in memory; `file` is for messages and for the place of a profile's CSV.
[[nodiscard]] Case case_from_text(std::string_view text, const std::filesystem::path& file);

/// The file as written, before its keys are looked at. Throws InputError where it is no plain text
/// or not TOML.
[[nodiscard]] CaseDocument read_case_document(const std::filesystem::path& file);

/// The case of a document, which may have been edited (mill/case_file/case_edit.h).
[[nodiscard]] Case case_from_document(const CaseDocument& document,
                                      const ReadDrawnLiner& draw = no_drawings);

}  // namespace millwear
