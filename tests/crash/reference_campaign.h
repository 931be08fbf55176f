#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/crash/campaign_process.h"

namespace millwear::crash {

inline const std::string case_file = MILLWEAR_CRASH_CASE;

[[nodiscard]] std::string text_of(const std::filesystem::path& file);
void put_text(const std::filesystem::path& file, const std::string& text);

/// A new folder, removed with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A stage of a campaign as its folder: "cycle_000/mesh".
using StageName = std::string;

/// Where a stage's files grow until it is published.
[[nodiscard]] std::filesystem::path partial_of(const std::filesystem::path& campaign,
                                               const StageName& stage);

/// The campaign of crash_mill.toml, run once and undisturbed for all tests of a program.
class ReferenceCampaign {
 public:
  /// Runs it when first asked for.
  static const ReferenceCampaign& get();

  /// All stages in the order they ran.
  [[nodiscard]] std::vector<StageName> stages() const;
  /// Makes `campaign` what it was when `stage` was about to begin.
  void copy_up_to(const StageName& stage, const std::filesystem::path& campaign) const;
  /// A copy of the whole finished campaign.
  void copy_to(const std::filesystem::path& campaign) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  ReferenceCampaign();
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "run";
};

/// The command that starts a campaign and resumes it.
[[nodiscard]] std::vector<std::string> run_into(const std::filesystem::path& campaign);

/// Expects that the same command ends well now, and leaves what the undisturbed campaign left.
void expect_resumes_to_the_same(const std::filesystem::path& campaign);

/// Expects that a stage is neither published nor in the ledger.
void expect_not_published(const std::filesystem::path& campaign, const StageName& stage);

}  // namespace millwear::crash
