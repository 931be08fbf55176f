#pragma once
#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mill/case_keys/case_document.h"
#include "mill/case_keys/case_key.h"
#include "mill/case_keys/key_value.h"

namespace millwear {

/// One key and the member of `Settings` that it fills. From a list of rows follow the reading of a
/// table (`read_keys`), its locked copy (`written_keys`), the schema check and the manual.
template <typename Settings>
struct KeyRow {
  KeySpec spec;
  /// Fills the member; empty where a builder has to read the key.
  std::function<void(Settings&, const CaseValue&)> read{};
  /// Fills the member where the key is missing; empty where it keeps its default.
  std::function<void(Settings&)> deduce{};
  /// The value for the locked copy, none where the key is left out of it.
  std::function<std::optional<std::string>(const Settings&)> written{};
};

/// The makers of rows: `key::defaulted("ranks", key::in(&DemSettings::ranks), at_least(0), "...")`.
namespace key {

/// Where a key's value is kept.
template <typename Settings, typename Value>
struct Place {
  std::function<void(Settings&, Value)> set;
  std::function<std::optional<Value>(const Settings&)> get;  ///< none where it was not given
};

template <typename Settings, typename Value>
[[nodiscard]] Place<Settings, Value> in(Value Settings::*member) {
  return {[member](Settings& settings, Value value) { settings.*member = std::move(value); },
          [member](const Settings& settings) { return std::optional(settings.*member); }};
}

template <typename Settings, typename Value>
[[nodiscard]] Place<Settings, Value> in(std::optional<Value> Settings::*member) {
  return {[member](Settings& settings, Value value) { settings.*member = std::move(value); },
          [member](const Settings& settings) { return settings.*member; }};
}

/// `place` holds SI units and the key another one; `to_si` is proportional
/// (mill/case/case_units.h).
template <typename Settings>
[[nodiscard]] Place<Settings, double> converted(double (*to_si)(double),
                                                Place<Settings, double> place) {
  return {[place, to_si](Settings& settings, double value) { place.set(settings, to_si(value)); },
          [place, to_si](const Settings& settings) {
            std::optional<double> value = place.get(settings);
            if (value) *value /= to_si(1.0);
            return value;
          }};
}

template <typename Settings>
[[nodiscard]] Place<Settings, std::vector<double>> converted(
    double (*to_si)(double), Place<Settings, std::vector<double>> place) {
  return {[place, to_si](Settings& settings, std::vector<double> values) {
            for (double& value : values) value = to_si(value);
            place.set(settings, std::move(values));
          },
          [place, to_si](const Settings& settings) {
            std::optional<std::vector<double>> values = place.get(settings);
            if (values)
              for (double& value : *values) value /= to_si(1.0);
            return values;
          }};
}

template <typename Settings, typename Value>
[[nodiscard]] KeyRow<Settings> row_of(Presence presence, std::string_view key,
                                      Place<Settings, Value> place, KeyRange range,
                                      std::string_view doc) {
  return {.spec = {"", key, key_type<Value>, presence, range, doc},
          .read = [place](Settings& settings,
                          const CaseValue& value) { place.set(settings, value_in<Value>(value)); },
          .written = [place](const Settings& settings) -> std::optional<std::string> {
            const std::optional<Value> value = place.get(settings);
            if (!value) return std::nullopt;
            return file_text(*value);
          }};
}

template <typename Settings, typename Value>
[[nodiscard]] KeyRow<Settings> required(std::string_view key, Place<Settings, Value> place,
                                        KeyRange range, std::string_view doc) {
  return row_of(Presence::required, key, std::move(place), range, doc);
}

template <typename Settings, typename Value>
[[nodiscard]] KeyRow<Settings> optional(std::string_view key, Place<Settings, Value> place,
                                        KeyRange range, std::string_view doc) {
  return row_of(Presence::optional, key, std::move(place), range, doc);
}

/// Its default is the one of the member in a `Settings{}`.
template <typename Settings>
[[nodiscard]] KeyRow<Settings> with_default(KeyRow<Settings> row) {
  row.spec.presence = Presence::defaulted;
  row.spec.default_text = row.written(Settings{}).value();
  return row;
}

template <typename Settings, typename Value>
[[nodiscard]] KeyRow<Settings> defaulted(std::string_view key, Place<Settings, Value> place,
                                         KeyRange range, std::string_view doc) {
  return with_default(row_of(Presence::defaulted, key, std::move(place), range, doc));
}

/// A key that takes one of the words that `name_of` gives to `choices`.
template <typename Settings, typename Choice>
[[nodiscard]] KeyRow<Settings> choice(Presence presence, std::string_view key,
                                      Place<Settings, Choice> place, std::vector<Choice> choices,
                                      std::string_view doc) {
  std::string words;
  for (const Choice word : choices) {
    words += (words.empty() ? "" : "|") + std::string(name_of(word));
  }
  KeyRow<Settings> row{
      .spec = {"", key, KeyType::choice, presence, any_value, doc, "", words},
      .read =
          [place, choices](Settings& settings, const CaseValue& value) {
            const auto& word = std::get<std::string>(value.data);
            place.set(settings, *std::find_if(choices.begin(), choices.end(),
                                              [&](Choice each) { return name_of(each) == word; }));
          },
      .written = [place](const Settings& settings) -> std::optional<std::string> {
        const std::optional<Choice> value = place.get(settings);
        if (!value) return std::nullopt;
        return file_text(name_of(*value));
      }};
  return presence == Presence::defaulted ? with_default(std::move(row)) : row;
}

/// A key that no single member holds: a builder reads it and `written_keys` asks for its text.
template <typename Settings>
[[nodiscard]] KeyRow<Settings> left_to_builder(Presence presence, KeyType type,
                                               std::string_view key, KeyRange range,
                                               std::string_view doc,
                                               std::string default_text = "") {
  return {.spec = {"", key, type, presence, range, doc, std::move(default_text)}};
}

/// `row` whose member follows from the keys before it where the key is missing.
template <typename Settings, typename Deduce>
[[nodiscard]] KeyRow<Settings> deduced(KeyRow<Settings> row, Deduce deduce) {
  row.deduce = std::move(deduce);
  return row;
}

/// A key of free text, which the locked copy names only where it is not the default.
template <typename Settings>
[[nodiscard]] KeyRow<Settings> words(std::string_view key, std::string Settings::*member,
                                     std::string_view doc) {
  const std::string usual = Settings{}.*member;
  return {
      .spec = {"", key, KeyType::words, Presence::defaulted, any_value, doc,
               file_text(std::string_view(usual))},
      .read = [member](Settings& settings,
                       const CaseValue& value) { settings.*member = value_in<std::string>(value); },
      .written = [member, usual](const Settings& settings) -> std::optional<std::string> {
        if (settings.*member == usual) return std::nullopt;
        return file_text(std::string_view(settings.*member));
      }};
}

/// `row` of a key that the locked copy names only where it is not at its default, so that a folder
/// of a program that did not have the key yet stays the folder of its case.
template <typename Settings>
[[nodiscard]] KeyRow<Settings> locked_unless_default(KeyRow<Settings> row) {
  row.written = [all = std::move(row.written)](const Settings& settings) {
    std::optional<std::string> text = all(settings);
    return text == all(Settings{}) ? std::nullopt : text;
  };
  return row;
}

}  // namespace key

template <typename Settings>
[[nodiscard]] std::vector<KeyRow<Settings>> rows_of(std::string_view table,
                                                    std::initializer_list<KeyRow<Settings>> keys) {
  std::vector<KeyRow<Settings>> rows(keys);
  for (KeyRow<Settings>& row : rows) row.spec.table = table;
  return rows;
}

/// Fills the members of `settings` from a table that has passed `check_against_schema`; nullptr
/// stands for a table that is missing.
template <typename Settings>
void read_keys(const std::vector<KeyRow<Settings>>& rows, const CaseTable* table,
               Settings& settings) {
  for (const KeyRow<Settings>& row : rows) {
    const CaseValue* const value = table == nullptr ? nullptr : table->find(row.spec.key);
    if (value == nullptr) {
      if (row.deduce) row.deduce(settings);
    } else if (row.read) {
      row.read(settings, *value);
    }
  }
}

/// Lines `key = value` of the locked copy. `by_builder` gives the value of a row that has none of
/// its own, or nothing.
template <typename Settings>
[[nodiscard]] std::string written_keys(
    const std::vector<KeyRow<Settings>>& rows, const Settings& settings,
    const std::function<std::optional<std::string>(std::string_view key)>& by_builder = {}) {
  std::string text;
  for (const KeyRow<Settings>& row : rows) {
    const std::optional<std::string> value = row.written  ? row.written(settings)
                                             : by_builder ? by_builder(row.spec.key)
                                                          : std::nullopt;
    if (value) text += std::string(row.spec.key) + " = " + *value + "\n";
  }
  return text;
}

}  // namespace millwear
