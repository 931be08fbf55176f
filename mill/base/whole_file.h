#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace millwear {

/// Writes a whole file, as a stage does into a folder that is published later. Throws DiskError.
void write_file(const std::filesystem::path& file, std::string_view text);

/// Reads a whole file. Throws DiskError.
[[nodiscard]] std::string read_file(const std::filesystem::path& file);

/// Makes a folder and those above it. Throws DiskError.
void make_folder(const std::filesystem::path& folder);

}  // namespace millwear
