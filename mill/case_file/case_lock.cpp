#include "mill/case_file/case_lock.h"

#include <fmt/format.h>

#include <iterator>
#include <optional>

#include "mill/case_keys/campaign_keys.h"
#include "mill/case_keys/charge_keys.h"
#include "mill/case_keys/dem_keys.h"
#include "mill/case_keys/mill_keys.h"
#include "mill/case_keys/wear_keys.h"

namespace millwear {
namespace {

constexpr std::string_view headline =
    "# The case as it is simulated, every default filled in. Written by millwear.\n";

std::string table(std::string_view heading) { return fmt::format("\n{}\n", heading); }

std::string name_of_material(const Case& mill, std::size_t material) {
  return file_text(mill.materials.at(material).name);
}

std::string lifter_text(const Case& mill) {
  std::string text = table("[lifter]");
  text += written_keys<Case>(lifter_keys(), mill, [&](std::string_view) {
    return name_of_material(mill, mill.liner_material);
  });
  text += "nodes_m = [\n";
  for (const Eigen::Vector2d& node : mill.liner.nodes) {
    fmt::format_to(std::back_inserter(text), "  [{}, {}],\n", node.x(), node.y());
  }
  return text + "]\n";
}

std::string materials_text(const Case& mill) {
  std::string text;
  for (const Material& material : mill.materials) {
    text += table("[[materials]]") + written_keys(material_keys(), material);
  }
  for (const MaterialPair& pair : mill.pairs) {
    text += table("[[pairs]]") + written_keys<MaterialPair>(pair_keys(), pair, [&](auto) {
              return fmt::format("[{}, {}]", name_of_material(mill, pair.first),
                                 name_of_material(mill, pair.second));
            });
  }
  return text;
}

/// Counts, whichever of its two forms the charge was given in.
std::string charge_text(const Case& mill) {
  std::string text = table("[charge]") + written_keys(charge_keys(), mill.charge);
  for (const ParticleClass& kind : mill.charge.classes) {
    text += table("[[charge.counts]]") + written_keys<ParticleClass>(count_keys(), kind, [&](auto) {
              return name_of_material(mill, kind.material);
            });
  }
  return text;
}

/// One law for all particles stands in [wear] itself, however the case wrote it.
bool is_one_for_all(const std::vector<WearMechanism>& mechanisms) {
  return mechanisms.size() == 1 && !mechanisms.front().material &&
         !mechanisms.front().least_diameter && !mechanisms.front().most_diameter;
}

std::string wear_text(const Case& mill) {
  const auto& mechanisms = mill.wear.mechanisms;
  if (is_one_for_all(mechanisms)) {
    return table("[wear]") + written_keys(one_law_keys(), mechanisms.front()) +
           written_keys(wear_keys(), mill.wear);
  }
  std::string text = table("[wear]") + written_keys(wear_keys(), mill.wear);
  for (const WearMechanism& mechanism : mechanisms) {
    text += table("[[wear.mechanisms]]") +
            written_keys<WearMechanism>(mechanism_keys(), mechanism,
                                        [&](auto) -> std::optional<std::string> {
                                          if (!mechanism.material) return std::nullopt;
                                          return name_of_material(mill, *mechanism.material);
                                        });
  }
  return text;
}

}  // namespace

std::string operation_text(const CampaignSettings& campaign) {
  std::string text;
  for (const OperatingChange& change : campaign.operation)
    text += table("[[campaign.operation]]") + written_keys(operation_keys(), change);
  return text;
}

std::string locked_case_text(const Case& mill) {
  return std::string(headline) + written_keys(top_keys(), mill) +  //
         table("[mill]") + written_keys(mill_keys(), mill) +       //
         lifter_text(mill) + materials_text(mill) + charge_text(mill) + table("[dem]") +
         written_keys(dem_keys(), mill.dem) +  //
         wear_text(mill) +                     //
         table("[campaign]") + written_keys(campaign_keys(), mill.campaign) +
         operation_text(mill.campaign);
}

}  // namespace millwear
