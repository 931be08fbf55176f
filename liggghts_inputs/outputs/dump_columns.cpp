#include "liggghts_inputs/outputs/dump_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

#include "mill/base/failure.h"

namespace millwear::liggghts {
namespace {

struct ContactPart {
  std::string_view keyword;
  int columns;
};

/// In the order in which LIGGGHTS 3.8.0 prints them. Behind `history` the number of columns depends
/// on the contact model; nothing is wanted there.
constexpr std::array<ContactPart, 12> contact_parts = {{{"pos", 6},
                                                        {"vel", 6},
                                                        {"id", 3},
                                                        {"force", 3},
                                                        {"force_normal", 3},
                                                        {"force_tangential", 3},
                                                        {"torque", 3},
                                                        {"history", 0},
                                                        {"contactArea", 1},
                                                        {"delta", 1},
                                                        {"heatFlux", 1},
                                                        {"contactPoint", 3}}};

struct Wanted {
  std::string_view keyword;
  int place;  ///< among the keyword's columns, from 0
  std::string_view meaning;
};

constexpr std::array<Wanted, 11> wanted_of_contacts = {
    {{"pos", 0, "x of the contact"},
     {"pos", 1, "y of the contact"},
     {"pos", 2, "z of the contact"},
     {"id", 1, "the triangle"},
     {"id", 2, "the particle"},
     {"force_normal", 0, "x of the normal force"},
     {"force_normal", 1, "y of the normal force"},
     {"force_normal", 2, "z of the normal force"},
     {"force_tangential", 0, "x of the tangential force"},
     {"force_tangential", 1, "y of the tangential force"},
     {"force_tangential", 2, "z of the tangential force"}}};

constexpr std::array<std::string_view, 12> wanted_of_spins = {
    "id", "type", "radius", "x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz"};

/// A column of the compute, by its number from 1.
struct NumberedColumn {
  int number;
  std::string_view meaning;
};

std::set<std::string, std::less<>> words_of(std::string_view keywords) {
  std::istringstream in{std::string(keywords)};
  std::set<std::string, std::less<>> words;
  for (std::string word; in >> word;) words.insert(word);
  return words;
}

std::vector<NumberedColumn> numbered_columns(std::string_view keywords) {
  const auto words = words_of(keywords);
  for (const auto& word : words)
    if (std::ranges::find(contact_parts, word, &ContactPart::keyword) == contact_parts.end()) {
      std::vector<std::string_view> known;
      for (const auto& part : contact_parts) known.push_back(part.keyword);
      throw InputError(
          fmt::format("compute wall/gran/local has no keyword \"{}\"; give those of the deck's "
                      "compute, of {}",
                      word, fmt::join(known, " ")));
    }
  std::map<std::string_view, int> first;  // column of each keyword, from 1
  int next = 1;
  for (const auto& part : contact_parts)
    if (words.contains(part.keyword)) {
      first[part.keyword] = next;
      next += part.columns;
    }
  std::vector<NumberedColumn> columns;
  for (const auto& wanted : wanted_of_contacts) {
    if (!words.contains(wanted.keyword))
      throw InputError(
          fmt::format("the wall contacts are of a compute wall/gran/local with \"{}\", and without "
                      "{}; the deck has to ask for {}",
                      keywords, wanted.keyword, usual_contact_keywords));
    columns.push_back({first[wanted.keyword] + wanted.place, wanted.meaning});
  }
  return columns;
}

/// ID of "c_ID[k]"; empty for any other name.
std::string_view compute_of(std::string_view name) {
  const auto bracket = name.find('[');
  if (!name.starts_with("c_") || !name.ends_with(']') || bracket == std::string_view::npos)
    return {};
  return name.substr(2, bracket - 2);
}

ChosenColumns no_columns(std::string problem) { return {{}, std::move(problem)}; }

ChosenColumns contacts_in(const std::vector<NumberedColumn>& wanted, std::string_view keywords,
                          std::span<const std::string_view> names) {
  std::set<std::string_view> computes;
  for (const auto name : names)
    if (const auto id = compute_of(name); !id.empty()) computes.insert(id);
  if (computes.size() != 1)
    return no_columns(fmt::format(
        "the columns of one compute wall/gran/local were expected, c_ID[1] c_ID[2] ..., not \"{}\"",
        fmt::join(names, " ")));
  ChosenColumns chosen;
  for (const auto& column : wanted) {
    const std::string name = fmt::format("c_{}[{}]", *computes.begin(), column.number);
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      return no_columns(
          fmt::format("there is no column {}, {} of a compute wall/gran/local with \"{}\"; dump it "
                      "too, or name the keywords of the deck's compute with "
                      "--contact-keywords",
                      name, column.meaning, keywords));
    chosen.columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return chosen;
}

ChosenColumns spins_in(std::span<const std::string_view> names) {
  ChosenColumns chosen;
  for (const auto name : wanted_of_spins) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      return no_columns(fmt::format("there is no column {}; the particles' dump needs {}", name,
                                    fmt::join(wanted_of_spins, " ")));
    chosen.columns.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return chosen;
}

}  // namespace

ChooseColumns choose_contact_columns(std::string_view keywords) {
  return [wanted = numbered_columns(keywords), words = std::string(keywords)](
             std::span<const std::string_view> names) { return contacts_in(wanted, words, names); };
}

ChooseColumns choose_spin_columns() { return spins_in; }

}  // namespace millwear::liggghts
