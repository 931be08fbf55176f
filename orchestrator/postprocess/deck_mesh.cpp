#include "orchestrator/postprocess/deck_mesh.h"

#include <fmt/format.h>

#include "meshgen/liner_mesh.h"
#include "meshgen/stl_file.h"
#include "mill/base/failure.h"
#include "mill/liner/mill_frame.h"
#include "mill/load/load_measurement.h"
#include "orchestrator/postprocess/deck_axes.h"
#include "wear/record/profile_index.h"

namespace millwear::orchestrator {
namespace {

std::vector<meshgen::StlFacet> facets_of(const std::filesystem::path& file) {
  try {
    return meshgen::read_stl(file);
  } catch (const Failure& problem) {
    throw InputError(problem.what());
  }
}

void check_on_liner(const Case& mill, const HandRun& run,
                    const std::vector<meshgen::StlFacet>& facets) {
  const double limit = load_measurement(mill, 1.0, 1.0, 0).contact_limit;
  const wear::ProfileIndex profile(mill.liner, 2.0 * limit);
  const Eigen::Matrix3d to_mill = axes_to_mill(run.turns_about, run.gravity);
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (const auto& corner : facets[i]) {
      const Eigen::Vector3d place = to_mill * corner;
      const auto master = to_master(mill.liner.sector, place.x(), place.z(), run.angle);
      if (profile.nearest(master.position).distance <= limit) continue;
      throw InputError(fmt::format(
          "{}: facet {} has a corner at {:.6g} {:.6g} {:.6g} m that does not lie on the case's "
          "liner; give the profile that the mesh follows with --profile, or the angle at which it "
          "stands with --angle-deg",
          run.mesh->string(), i + 1, corner.x(), corner.y(), corner.z()));
    }
}

}  // namespace

std::size_t triangles_of_deck(const Case& mill, const HandRun& run) {
  if (!run.mesh)
    return meshgen::build_liner_mesh(mill.liner, mill.slice_length,
                                     {.tolerance = mesh_tolerance(mill)})
        .triangles.size();
  const auto facets = facets_of(*run.mesh);
  check_on_liner(mill, run, facets);
  return facets.size();
}

}  // namespace millwear::orchestrator
