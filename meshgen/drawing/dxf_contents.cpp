#include "meshgen/drawing/dxf_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include "mill/base/number_text.h"
#include "mill/base/user_table.h"

namespace millwear::meshgen {
namespace {

namespace fs = std::filesystem;
using Groups = std::vector<DxfGroup>;

constexpr int type_code = 0;
constexpr int name_code = 2;
constexpr int handle_code = 5;
constexpr int layer_code = 8;
constexpr int x_code = 10;

constexpr std::array<std::string_view, 7> curves = {"LINE",   "ARC",     "LWPOLYLINE", "POLYLINE",
                                                    "SPLINE", "ELLIPSE", "INSERT"};

/// Why an entity that is no curve is left out.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> reasons{{
    {"CIRCLE", "it is closed"},
    {"TEXT", "it is a text"},
    {"MTEXT", "it is a text"},
    {"ATTDEF", "it is a text"},
    {"DIMENSION", "it is a dimension"},
    {"LEADER", "it is a dimension"},
    {"MULTILEADER", "it is a dimension"},
    {"HATCH", "it is a hatch"},
    {"SOLID", "it is a filled area"},
    {"3DFACE", "it is three-dimensional"},
    {"3DSOLID", "it is three-dimensional"},
    {"MESH", "it is three-dimensional"},
    {"BODY", "it is three-dimensional"},
}};

struct Layer {
  bool is_off;
  bool is_frozen;
};

/// An entity with those that belong to it: the vertices of a POLYLINE, the attributes of an INSERT.
using Entity = Groups;

/// Of a group that is one (`dxf_groups` has looked).
double number(const DxfGroup& group) { return number_of(group.value).value(); }

/// The first value of a code in the entity itself.
const DxfGroup* value_of(const Entity& entity, int code) {
  for (std::size_t i = 1; i < entity.size() && entity[i].code != type_code; ++i)
    if (entity[i].code == code) return &entity[i];
  return nullptr;
}

int whole_number(const Entity& entity, int code, int otherwise) {
  const DxfGroup* const group = value_of(entity, code);
  return group == nullptr ? otherwise : static_cast<int>(number(*group));
}

const std::string& type_of(const Entity& entity) { return entity.front().value; }

std::string layer_of(const Entity& entity) {
  const DxfGroup* const group = value_of(entity, layer_code);
  return group == nullptr ? "0" : group->value;
}

bool belongs_to_the_last(const DxfGroup& type) {
  return type.value == "VERTEX" || type.value == "ATTRIB" || type.value == "SEQEND";
}

std::map<std::string, Layer> layers_of(const Groups& groups) {
  constexpr int colour_code = 62;
  constexpr int flags_code = 70;
  constexpr int frozen_flag = 1;
  std::map<std::string, Layer> layers;
  for (auto at = groups.begin(); at != groups.end(); ++at) {
    if (at->code != type_code || at->value != "LAYER") continue;
    const auto end =
        std::find_if(at + 1, groups.end(), [](const DxfGroup& g) { return g.code == type_code; });
    const Entity row(at, end);
    if (const DxfGroup* const name = value_of(row, name_code))
      layers[name->value] = {whole_number(row, colour_code, 7) < 0,
                             (whole_number(row, flags_code, 0) & frozen_flag) != 0};
  }
  return layers;
}

std::optional<LengthUnit> unit_of(const Groups& groups) {
  const auto variable = std::ranges::find_if(
      groups, [](const DxfGroup& g) { return g.code == 9 && g.value == "$INSUNITS"; });
  if (variable == groups.end() || variable + 1 == groups.end()) return std::nullopt;
  const auto unit = number_of((variable + 1)->value);
  return unit ? length_unit_of_insert(static_cast<int>(*unit)) : std::nullopt;
}

std::string reason_for(const Entity& entity, const std::map<std::string, Layer>& layers) {
  constexpr int invisible_code = 60;
  constexpr int paper_code = 67;
  constexpr int flags_code = 70;
  constexpr int mesh_flags = 16 | 64;
  const std::string& type = type_of(entity);
  if (std::ranges::find(curves, type) == curves.end()) {
    const auto known =
        std::ranges::find(reasons, type, &std::pair<std::string_view, std::string_view>::first);
    return known == reasons.end() ? "it is no curve" : std::string(known->second);
  }
  if (const auto layer = layers.find(layer_of(entity)); layer != layers.end()) {
    if (layer->second.is_frozen) return "its layer is frozen";
    if (layer->second.is_off) return "its layer is off";
  }
  if (whole_number(entity, invisible_code, 0) == 1) return "it is invisible";
  if (whole_number(entity, paper_code, 0) == 1) return "it is in paper space";
  if (type == "POLYLINE" && (whole_number(entity, flags_code, 0) & mesh_flags) != 0)
    return "it is three-dimensional";
  return {};
}

long count_of(const Entity& entity, int code) {
  return std::ranges::count(entity, code, &DxfGroup::code);
}

void check_vertices(const Entity& entity, const fs::path& file) {
  constexpr int count_code = 90;
  const int said = whole_number(entity, count_code, -1);
  const long found = count_of(entity, x_code);
  if (said == found) return;
  refuse_line(file, entity.front().line,
              fmt::format("a polyline says that it has {} vertices, and has {}; mend the drawing",
                          said, found));
}

void check_spline(const Entity& entity, const fs::path& file) {
  constexpr int degree_code = 71;
  constexpr int knot_code = 40;
  const int degree = whole_number(entity, degree_code, 3);
  const long knots = count_of(entity, knot_code);
  const long points = count_of(entity, x_code);
  if (points == 0)
    refuse_line(file, entity.front().line,
                "a spline has fit points alone; convert it to one with control points");
  if (degree < 1 || points <= degree || knots != points + degree + 1)
    refuse_line(file, entity.front().line,
                fmt::format("a spline of degree {} with {} control points takes {} knots, and has "
                            "{}; mend the drawing",
                            degree, points, points + degree + 1, knots));
  const DxfGroup* last = nullptr;
  for (const DxfGroup& group : entity) {
    if (group.code != knot_code) continue;
    if (last != nullptr && number(group) < number(*last))
      refuse_line(file, group.line, "the knots of a spline fall; mend the drawing");
    last = &group;
  }
}

void check(const Entity& entity, const fs::path& file) {
  if (type_of(entity) == "LWPOLYLINE") check_vertices(entity, file);
  if (type_of(entity) == "SPLINE") check_spline(entity, file);
}

/// The entity with its line for a handle.
void append(const Entity& entity, Groups& to) {
  to.push_back(entity.front());
  to.push_back({handle_code, fmt::format("{}", entity.front().line), entity.front().line});
  std::copy_if(entity.begin() + 1, entity.end(), std::back_inserter(to),
               [](const DxfGroup& group) { return group.code != handle_code; });
}

/// What does not belong to entities but stands among them.
bool is_structure(const DxfGroup& type) {
  return type.value == "SECTION" || type.value == "ENDSEC" || type.value == "BLOCK" ||
         type.value == "ENDBLK" || type.value == "EOF";
}

bool holds_entities(const std::string& section) {
  return section == "ENTITIES" || section == "BLOCKS";
}

}  // namespace

DxfContents dxf_contents(Groups groups, const fs::path& file) {
  const auto layers = layers_of(groups);
  DxfContents contents{{}, {}, {}, unit_of(groups)};
  std::string section;
  bool is_anonymous_block = false;
  for (auto at = groups.begin(); at != groups.end();) {
    auto end =
        std::find_if(at + 1, groups.end(), [](const DxfGroup& g) { return g.code == type_code; });
    if (at->code == type_code && at->value == "SECTION" && at + 1 != groups.end())
      section = (at + 1)->value;
    const bool is_entity = at->code == type_code && holds_entities(section) && !is_structure(*at);
    if (!is_entity) {
      const Entity row(at, end);
      const DxfGroup* const name = value_of(row, name_code);
      if (at->value == "BLOCK")
        is_anonymous_block = name != nullptr && name->value.starts_with('*');
      if (at->value == "ENDBLK") is_anonymous_block = false;
      contents.groups.insert(contents.groups.end(), at, end);
      at = end;
      continue;
    }
    while (end != groups.end() && belongs_to_the_last(*end))
      end = std::find_if(end + 1, groups.end(),
                         [](const DxfGroup& g) { return g.code == type_code; });
    const Entity entity(at, end);
    const std::string reason = reason_for(entity, layers);
    if (reason.empty()) {
      check(entity, file);
      contents.types.emplace(entity.front().line, type_of(entity));
      append(entity, contents.groups);
    } else if (!is_anonymous_block) {
      contents.left_out.push_back({type_of(entity), layer_of(entity), entity.front().line, reason});
    }
    at = end;
  }
  return contents;
}

}  // namespace millwear::meshgen
