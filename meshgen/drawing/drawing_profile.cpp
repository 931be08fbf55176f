#include "meshgen/drawing/drawing_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "meshgen/drawing/curve_chains.h"
#include "meshgen/drawing/drawn_pieces.h"
#include "meshgen/drawing/dxf_contents.h"
#include "mill/base/failure.h"
#include "mill/base/whole_file.h"

namespace millwear::meshgen {
namespace {

namespace fs = std::filesystem;

/// Of entities, by their lines.
using Types = std::map<int, std::string>;

/// Gaps that are closed, as a share of the size of the drawing.
constexpr double gap = 1e-4;
/// What another open curve may have of the profile's length.
constexpr double most_of_another = 0.5;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw InputError(fmt::format("{}: {}", file.string(), what));
}

std::string bytes_of(const fs::path& file) {
  if (!fs::is_regular_file(file)) refuse(file, "there is no such file; check its name");
  if (fs::file_size(file) > largest_drawing)
    refuse(file, fmt::format("the file is over {} MiB; keep one profile a drawing",
                             largest_drawing >> 20));
  return read_file(file);
}

/// The code page of a drawing as iconv calls it: UTF-8 from 2007 on, else `$DWGCODEPAGE`.
std::string code_page_of(const std::vector<DxfGroup>& groups) {
  constexpr std::string_view first_with_utf8 = "AC1021";
  std::string page = "CP1252";
  for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
    if (groups[i].code != 9) continue;
    const std::string& value = groups[i + 1].value;
    if (groups[i].value == "$ACADVER" && value >= first_with_utf8) return "UTF-8";
    if (groups[i].value == "$DWGCODEPAGE" &&
        (value.starts_with("ANSI_") || value.starts_with("ansi_")))
      page = "CP" + value.substr(5);
  }
  return page;
}

/// "LINE (line 24)".
std::string spoken(const DrawnPiece& piece, const Types& types) {
  const auto type = types.find(piece.line);
  return fmt::format("{} (line {})", type == types.end() ? "a curve" : type->second, piece.line);
}

std::string spoken(const LeftOut& left, const std::string& code_page) {
  return fmt::format("{} (line {}) on layer `{}`: {}", left.entity, left.line,
                     utf8_of(left.layer, code_page), left.why);
}

double size_of(const std::vector<DrawnPiece>& pieces) {
  Eigen::Vector2d low = pieces.front().nodes.front();
  Eigen::Vector2d high = low;
  for (const DrawnPiece& piece : pieces)
    for (const auto& node : piece.nodes) {
      low = low.cwiseMin(node);
      high = high.cwiseMax(node);
    }
  return (high - low).norm();
}

/// The pieces on a layer; all without one.
std::vector<DrawnPiece> pieces_on(const std::optional<std::string>& layer,
                                  std::vector<DrawnPiece> pieces, const fs::path& file) {
  if (!layer || pieces.empty()) return pieces;
  std::set<std::string> layers;
  for (const DrawnPiece& piece : pieces) layers.insert(fmt::format("`{}`", piece.layer));
  std::erase_if(pieces, [&](const DrawnPiece& piece) { return piece.layer != *layer; });
  if (pieces.empty())
    refuse(file, fmt::format("no curve is on layer `{}`; they are on {}", *layer,
                             fmt::join(layers, ", ")));
  return pieces;
}

std::string list_of(const std::vector<std::string>& left_out) {
  constexpr std::size_t most = 5;
  if (left_out.empty()) return "";
  const std::vector<std::string> shown(
      left_out.begin(),
      left_out.begin() + static_cast<std::ptrdiff_t>(std::min(most, left_out.size())));
  return fmt::format(
      " (left out: {}{})", fmt::join(shown, "; "),
      left_out.size() > most ? fmt::format("; and {} more", left_out.size() - most) : "");
}

/// The longest of the open chains. Names the others and the closed ones in `left_out`.
CurveChain profile_among(std::vector<CurveChain> chains, const std::vector<DrawnPiece>& pieces,
                         const Types& types, const fs::path& file,
                         std::vector<std::string>& left_out) {
  const auto named = [&](const CurveChain& chain) {
    const DrawnPiece& first = pieces[chain.pieces.front()];
    return fmt::format("{} on layer `{}`", spoken(first, types), first.layer);
  };
  std::erase_if(chains, [&](const CurveChain& chain) {
    if (chain.is_closed) left_out.push_back(named(chain) + ": it is closed");
    return chain.is_closed;
  });
  if (chains.empty())
    refuse(file, fmt::format("no open curve is drawn{}; keep the surface that the charge touches, "
                             "from plate to plate",
                             list_of(left_out)));
  std::ranges::stable_sort(chains, std::ranges::greater{},
                           [](const CurveChain& chain) { return length_of(chain.nodes); });
  const CurveChain& longest = chains.front();
  if (chains.size() > 1 && length_of(chains[1].nodes) > most_of_another * length_of(longest.nodes))
    refuse(file,
           fmt::format("two open curves are drawn, {} and {}; join them within {:.3g}, or keep "
                       "the profile alone on a layer and name it with --layer",
                       named(longest), named(chains[1]), gap * size_of(pieces)));
  if (longest.ends_at_a_junction)
    refuse(file,
           fmt::format("more than two curves meet where the profile ends, ({:.6g}, {:.6g}) or "
                       "({:.6g}, {:.6g}); keep the profile alone on a layer and name it with "
                       "--layer",
                       longest.nodes.front().x(), longest.nodes.front().y(),
                       longest.nodes.back().x(), longest.nodes.back().y()));
  for (std::size_t i = 1; i < chains.size(); ++i)
    left_out.push_back(named(chains[i]) + ": it is shorter than the profile");
  return longest;
}

}  // namespace

DrawingProfile drawing_profile(const fs::path& file, const std::optional<std::string>& layer) {
  const DxfContents contents = dxf_contents(dxf_groups(bytes_of(file), file), file);
  const std::string code_page = code_page_of(contents.groups);
  DrawingProfile profile{{}, contents.unit, {}, {}};
  for (const LeftOut& left : contents.left_out) profile.left_out.push_back(spoken(left, code_page));
  const auto pieces = pieces_on(layer, drawn_pieces(dxf_text(contents.groups), file), file);
  if (pieces.empty())
    refuse(file,
           fmt::format("nothing is drawn that could be a profile{}; draw it with lines, arcs, "
                       "polylines or splines, and insert the block that it is in",
                       list_of(profile.left_out)));
  std::vector<Curve> curves;
  for (const DrawnPiece& piece : pieces) curves.push_back(piece.nodes);
  CurveChain chain = profile_among(curve_chains(curves, gap * size_of(pieces)), pieces,
                                   contents.types, file, profile.left_out);
  profile.nodes = std::move(chain.nodes);
  for (const std::size_t piece : chain.pieces)
    profile.drawn_as.push_back(spoken(pieces[piece], contents.types));
  return profile;
}

}  // namespace millwear::meshgen
