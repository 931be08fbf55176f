#include "orchestrator/app/draw_verb.h"

#include <CLI/CLI.hpp>

#include "mill/base/published_file.h"
#include "mill/base/whole_file.h"
#include "orchestrator/app/liner_choice.h"
#include "orchestrator/campaign/output_path.h"
#include "orchestrator/pictures/liner_drawing.h"

namespace millwear::orchestrator {

void add_options(CLI::App& verb, DrawOptions& options) {
  add_options(verb, options.common);
  verb.add_option("--out", options.out, "Folder of the drawings; by default drawings/NAME");
  add_worn_profile(verb, options.profile);
}

void publish_drawings(const Case& mill, const std::filesystem::path& folder) {
  const std::string svg = liner_drawing(mill, DrawingFormat::svg);
  const std::string png = liner_drawing(mill, DrawingFormat::png);
  make_folder(folder);
  publish(folder / "liner.svg", svg);
  publish(folder / "liner.png", png);
}

void draw_verb(const DrawOptions& options) {
  const Case mill = case_with_profile(options.common, options.profile);
  const auto folder = folder_or_default(options.out, "drawings", mill);
  check_output_folder("--out", folder);
  publish_drawings(mill, folder);
  print_folder(options.common, folder, "liner.svg and liner.png are");
}

}  // namespace millwear::orchestrator
