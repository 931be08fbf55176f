#include "recorder/run/deck_lines.h"

namespace millwear::recorder {
namespace {

constexpr std::string_view blank = " \t\r";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

}  // namespace

std::vector<std::string> deck_lines(std::string_view deck) {
  std::vector<std::string> lines;
  std::string joined;
  while (!deck.empty()) {
    const auto end = deck.find('\n');
    std::string_view line = trimmed(deck.substr(0, end));
    deck.remove_prefix(end == std::string_view::npos ? deck.size() : end + 1);
    const bool goes_on = line.ends_with('&');
    if (goes_on) line.remove_suffix(1);
    joined += line;
    if (goes_on) {
      joined += ' ';
      continue;
    }
    if (!joined.empty() && joined.front() != '#') lines.push_back(joined);
    joined.clear();
  }
  if (!joined.empty()) lines.push_back(joined);
  return lines;
}

std::string_view command_of(std::string_view line) {
  const auto words = trimmed(line);
  return words.substr(0, words.find_first_of(blank));
}

std::string_view argument_of(std::string_view line) {
  const auto words = trimmed(line);
  const auto end = words.find_first_of(blank);
  return end == std::string_view::npos ? std::string_view{} : command_of(words.substr(end));
}

}  // namespace millwear::recorder
