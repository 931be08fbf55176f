#include "mill/recording/recorder_option.h"

#include <fmt/format.h>

namespace millwear {

void append(std::vector<std::string>& words, const RecorderOption& option, long value) {
  words.insert(words.end(), {option.name, std::to_string(value)});
}

// The shortest text that is read back as the same double.
void append(std::vector<std::string>& words, const RecorderOption& option, double value) {
  words.insert(words.end(), {option.name, fmt::format("{}", value)});
}

void append(std::vector<std::string>& words, const RecorderOption& option,
            const std::filesystem::path& value) {
  words.insert(words.end(), {option.name, value.string()});
}

}  // namespace millwear
