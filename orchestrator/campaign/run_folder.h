#pragma once
#include <filesystem>

#include "orchestrator/campaign/stage.h"

namespace millwear::orchestrator {

/// Where a campaign keeps its files (docs/file_formats.md).
struct RunFolder {
  std::filesystem::path root;

  [[nodiscard]] std::filesystem::path locked_case() const { return root / "case.lock.toml"; }
  [[nodiscard]] std::filesystem::path ledger() const { return root / "ledger.jsonl"; }
  [[nodiscard]] std::filesystem::path lock() const { return root / ".lock"; }
  [[nodiscard]] std::filesystem::path results() const { return root / "results"; }
  [[nodiscard]] std::filesystem::path report() const { return root / "report.html"; }
  [[nodiscard]] std::filesystem::path stage(const StageId& id) const;
  /// Where a stage's files grow before they are published by one rename.
  [[nodiscard]] std::filesystem::path partial_stage(const StageId& id) const;
};

/// Files of the stages, named from the stage's own folder.
namespace stage_files {
inline constexpr const char* mesh = "liner.stl";
inline constexpr const char* mesh_facts = "mesh.json";
inline constexpr const char* profile = "profile.csv";
inline constexpr const char* profile_step = "profile.step";
inline constexpr const char* profile_dxf = "profile.dxf";
inline constexpr const char* tuning = "tuning.json";
inline constexpr const char* mixing = "mixing.csv";
inline constexpr const char* load = "load.h5";
inline constexpr const char* events = "events.h5";
inline constexpr const char* charge = "charge.h5";
inline constexpr const char* measured = "measured.json";
inline constexpr const char* steps = "steps.json";
}  // namespace stage_files

}  // namespace millwear::orchestrator
