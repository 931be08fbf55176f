#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "orchestrator/study/study_points.h"

namespace millwear::orchestrator {

/// Where a study keeps its files (docs/file_formats.md).
struct StudyFolder {
  std::filesystem::path root;

  [[nodiscard]] std::filesystem::path points() const { return root / "points"; }
  [[nodiscard]] std::filesystem::path by_value() const { return root / "by"; }
  [[nodiscard]] std::filesystem::path base_charge() const { return root / "charge"; }
  [[nodiscard]] std::filesystem::path lock() const { return root / ".lock"; }
  [[nodiscard]] std::filesystem::path locked_study() const { return root / "study.lock.toml"; }
  [[nodiscard]] std::filesystem::path jobs() const { return root / "jobs.tsv"; }
  [[nodiscard]] std::filesystem::path search() const { return root / "search.csv"; }
  [[nodiscard]] std::filesystem::path table() const { return root / "study.csv"; }
  [[nodiscard]] std::filesystem::path json() const { return root / "study.json"; }
  [[nodiscard]] std::filesystem::path page() const { return root / "study.html"; }
};

/// The folders under `points` that a study has already, by the hash in their names.
[[nodiscard]] std::map<std::string, std::filesystem::path> point_folders(const StudyFolder& folder);

/// The folder of every campaign: the one that has its hash, or a new one with the next number,
/// `points/0007-<hash>`. Nothing is written. Throws InputError where a folder's case was edited.
[[nodiscard]] std::vector<std::filesystem::path> folders_of(const StudyFolder& folder,
                                                            const StudyPlan& plan);

/// Makes the folders with their `case.toml`, and `study.lock.toml` anew. Throws InputError where
/// the folder belongs to a study of another base case.
void keep_plan(const StudyFolder& folder, const StudyPlan& plan,
               const std::vector<std::filesystem::path>& campaigns);

/// Makes `by/rows=12/height_m=0.04/seed=1`, links to the campaigns, anew. What does not vary is
/// left out.
void link_by_value(const StudyFolder& folder, const StudyPlan& plan,
                   const std::vector<std::filesystem::path>& campaigns);

}  // namespace millwear::orchestrator
