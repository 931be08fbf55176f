#include "orchestrator/campaign/mesh_files.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "meshgen/liner_mesh.h"
#include "meshgen/mesh_check.h"
#include "meshgen/profile_cad.h"
#include "meshgen/stl_file.h"
#include "mill/base/failure.h"
#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/campaign/run_folder.h"

namespace millwear::orchestrator {

namespace {

struct CheckedMesh {
  meshgen::LinerMesh mesh;
  meshgen::MeshReport found;
};

CheckedMesh checked_mesh(const Case& mill, const LinerProfile& liner) {
  const meshgen::MeshSettings settings{.tolerance = mesh_tolerance(mill)};
  auto mesh = meshgen::build_liner_mesh(liner, mill.slice_length, settings);
  const auto found = meshgen::check_mesh(mesh, liner, settings);
  return {std::move(mesh), found};
}

}  // namespace

void check_liner_can_be_meshed(const Case& mill) {
  try {
    static_cast<void>(checked_mesh(mill, mill.liner));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", mill.file.string(), error.what()));
  }
}

void write_mesh(const Case& mill, const LinerProfile& liner, const std::filesystem::path& into) {
  const auto [mesh, found] = checked_mesh(mill, liner);
  meshgen::write_stl(mesh, into / stage_files::mesh);
  publish(into / stage_files::profile, profile_csv(liner));
  meshgen::write_dxf(liner, into / stage_files::profile_dxf);
  meshgen::write_step(liner, mill.slice_length, into / stage_files::profile_step);
  const nlohmann::json facts = {
      {"type", "millwear mesh"},
      {"format_version", 1},
      {"triangles", mesh.triangles.size()},
      {"rows", mesh.rows},
      {"facets_per_lifter", mesh.facets_per_lifter},
      {"layers", mesh.layers},
      {"tolerance_m", mesh_tolerance(mill)},
      {"largest_deviation_m", found.largest_deviation},
      {"smallest_angle_deg", found.smallest_angle * 180.0 / std::numbers::pi}};
  publish(into / stage_files::mesh_facts, facts.dump(1) + "\n");
}

void write_mesh_stl(const Case& mill, const LinerProfile& liner,
                    const std::filesystem::path& file) {
  meshgen::write_stl(checked_mesh(mill, liner).mesh, file);
}

std::size_t triangles_of_mesh(const std::filesystem::path& mesh_folder) {
  const auto facts = nlohmann::json::parse(read_file(mesh_folder / stage_files::mesh_facts));
  return facts.at("triangles").get<std::size_t>();
}

}  // namespace millwear::orchestrator
