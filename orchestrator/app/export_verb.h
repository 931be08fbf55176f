#pragma once
#include <filesystem>
#include <optional>

#include "orchestrator/app/common_options.h"
#include "orchestrator/export/liner_surface.h"

namespace millwear::orchestrator {

/// What `millwear export` is told.
struct ExportOptions {
  CommonOptions common;
  std::filesystem::path out;                      ///< empty: runs/NAME
  std::optional<std::filesystem::path> paraview;  ///< folder to be written
  LinerExtent extent = LinerExtent::ring;         ///< of the liner in it
  std::optional<std::filesystem::path> images;    ///< folder for the pictures of one cycle
  std::optional<std::filesystem::path> stl;       ///< files to be written of one step's liner
  std::optional<std::filesystem::path> step;
  std::optional<std::filesystem::path> dxf;
  std::optional<std::filesystem::path> csv;
  std::optional<int> cycle;    ///< whose step and pictures; none: the last
  std::optional<int> at_step;  ///< which; none: the last of the cycle
};

void add_options(CLI::App& verb, ExportOptions& options);

/// Writes what is published of a campaign for other programs; the campaign's folder stays as it is.
void export_verb(const ExportOptions& options);

}  // namespace millwear::orchestrator
