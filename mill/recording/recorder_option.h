#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace millwear {

enum class OptionNeed { required, optional };

/// The numbers that an option takes.
enum class OptionRange { any, not_negative, positive };

/// An option of millwear-recorder. Who starts the recorder and the recorder itself both read the
/// option's name here, so that neither can spell it differently.
struct RecorderOption {
  const char* name;  ///< "--after"
  const char* help;  ///< a line of --help
  OptionNeed need = OptionNeed::required;
  OptionRange range = OptionRange::any;
  const char* short_name = "";  ///< "-i"
};

/// Appends the option and its value to the words of a command line; a value that is not set gives
/// no word.
void append(std::vector<std::string>& words, const RecorderOption& option, long value);
void append(std::vector<std::string>& words, const RecorderOption& option, double value);
void append(std::vector<std::string>& words, const RecorderOption& option,
            const std::filesystem::path& value);

template <class Value>
void append(std::vector<std::string>& words, const RecorderOption& option,
            const std::optional<Value>& value) {
  if (value) append(words, option, *value);
}

}  // namespace millwear
