#include "orchestrator/app/mesh_verb.h"

#include <CLI/CLI.hpp>

#include "mill/base/whole_file.h"
#include "orchestrator/app/liner_choice.h"
#include "orchestrator/campaign/mesh_files.h"
#include "orchestrator/campaign/output_path.h"

namespace millwear::orchestrator {

void add_options(CLI::App& verb, MeshOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--out", options.out, "Folder of the files; by default mesh/NAME");
  add_worn_profile(verb, options.profile);
}

void mesh_verb(const MeshOptions& options) {
  const Case mill = case_with_profile(options.common, options.profile);
  const auto folder = folder_or_default(options.out, "mesh", mill);
  check_output_folder("--out", folder);
  make_folder(folder);
  write_mesh(mill, mill.liner, folder);
  print_folder(options.common, folder,
               "liner.stl, profile.csv, profile.step, profile.dxf and mesh.json are");
}

}  // namespace millwear::orchestrator
