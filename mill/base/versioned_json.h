#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"

namespace millwear {

/// What `parse` makes of a JSON file of this type and format version. Throws DiskError where it
/// cannot be read, and ResultRejected, naming it, where it is another or cannot be understood.
template <class Parse>
auto read_versioned_json(const std::filesystem::path& file, std::string_view type, int version,
                         Parse parse) {
  try {
    const auto document = nlohmann::json::parse(read_file(file));
    if (document.at("type").get<std::string>() != type ||
        document.at("format_version").get<int>() != version)
      throw ResultRejected(fmt::format("it is not a {} of version {}", type, version));
    return parse(document);
  } catch (const DiskError&) {
    throw;
  } catch (const std::exception& problem) {
    throw ResultRejected(fmt::format("{}: {}", file.string(), problem.what()));
  }
}

}  // namespace millwear
