#pragma once
#include <cstdint>
#include <cstring>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace millwear::orchestrator {

/// A .vtp file as a reader of VTK's XML format takes it: elements by their nesting, every array
/// from its offset behind the underscore of `AppendedData`, after its length as UInt64. Written
/// from the format's description, without the writer. Throws std::runtime_error where the file
/// breaks a rule.
struct ReadVtp {
  struct Array {
    std::string type;
    int components;
    std::vector<double> values;
  };
  std::map<std::string, std::string> head;   ///< attributes of VTKFile
  std::map<std::string, std::string> piece;  ///< attributes of Piece
  std::map<std::string, Array> arrays;       ///< "PointData/speed" and so on

  [[nodiscard]] const std::vector<double>& operator[](const std::string& name) const {
    return arrays.at(name).values;
  }
};

namespace vtp {

template <class T>
std::vector<double> numbers(const std::string& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  if (values.size() * sizeof(T) != bytes.size()) throw std::runtime_error("half a number");
  // Of an array without values data() is null, which memcpy may not take.
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return {values.begin(), values.end()};
}

inline std::vector<double> numbers_of(const std::string& type, const std::string& bytes) {
  if (type == "UInt8") return numbers<std::uint8_t>(bytes);
  if (type == "Int32") return numbers<std::int32_t>(bytes);
  if (type == "Float32") return numbers<float>(bytes);
  if (type == "Float64") return numbers<double>(bytes);
  throw std::runtime_error("no type of VTK: " + type);
}

}  // namespace vtp

inline ReadVtp read_vtp(const std::string& file) {
  const std::string opening = "<AppendedData encoding=\"raw\">";
  const auto appended = file.find(opening);
  const auto bytes = file.find('_', appended) + 1;
  const auto end = file.rfind("</AppendedData>");
  if (appended == std::string::npos || bytes == 0 || end == std::string::npos)
    throw std::runtime_error("no appended data");
  const std::string xml =
      file.substr(0, appended + opening.size()) + file.substr(end, std::string::npos);
  ReadVtp read;
  std::vector<std::string> open;
  static const std::regex tag(R"(<(/?)(\w+)((?:\s+\w+="[^"]*")*)\s*(/?)>)");
  static const std::regex attribute(R"re((\w+)="([^"]*)")re");
  for (std::sregex_iterator found(xml.begin(), xml.end(), tag), last; found != last; ++found) {
    const std::string name = (*found)[2];
    if ((*found)[1].length() > 0) {
      if (open.empty() || open.back() != name) throw std::runtime_error("not nested: " + name);
      open.pop_back();
      continue;
    }
    std::map<std::string, std::string> attributes;
    const std::string text = (*found)[3];
    for (std::sregex_iterator a(text.begin(), text.end(), attribute), none; a != none; ++a)
      attributes[(*a)[1]] = (*a)[2];
    if (name == "VTKFile") read.head = attributes;
    if (name == "Piece") read.piece = attributes;
    if (name == "DataArray") {
      std::uint64_t length = 0;
      const auto at = bytes + std::stoul(attributes.at("offset"));
      if (at + sizeof length > end) throw std::runtime_error("an offset behind the end");
      std::memcpy(&length, file.data() + at, sizeof length);
      if (at + sizeof length + length > end) throw std::runtime_error("an array behind the end");
      const std::string components =
          attributes.contains("NumberOfComponents") ? attributes["NumberOfComponents"] : "1";
      read.arrays[open.back() + "/" + attributes.at("Name")] = {
          attributes.at("type"), std::stoi(components),
          vtp::numbers_of(attributes.at("type"), file.substr(at + sizeof length, length))};
    }
    if ((*found)[4].length() == 0) open.push_back(name);
  }
  if (!open.empty()) throw std::runtime_error("not closed: " + open.back());
  return read;
}

}  // namespace millwear::orchestrator
