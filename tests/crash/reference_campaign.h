#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "tests/crash/campaign_process.h"

namespace millwear::crash {

inline const std::string case_file = MILLWEAR_CRASH_CASE;
inline const std::string recorder_comm =
    "millwear-record";  ///< its name, as long as /proc gives it

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

/// A campaign that was run once and undisturbed for all tests of a program.
class ReferenceCampaign {
 public:
  /// That of crash_mill.toml; runs it when first asked for.
  static const ReferenceCampaign& get();
  /// The same through the text dumps of the plain liggghts.
  static const ReferenceCampaign& of_dumps();

  /// The same mill, turned around at `reversal_hours` within its first cycle, for two cycles.
  static const ReferenceCampaign& of_a_reversal();

  /// The same mill, sped up with fewer balls at `reversal_hours`, for two cycles.
  static const ReferenceCampaign& of_a_change();

  /// All stages in the order they ran.
  [[nodiscard]] std::vector<StageName> stages() const;
  /// Makes `campaign` what it was when `stage` was about to begin.
  void copy_up_to(const StageName& stage, const std::filesystem::path& campaign) const;
  /// A copy of the whole finished campaign.
  void copy_to(const std::filesystem::path& campaign) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::filesystem::path& mill() const { return case_; }

 private:
  explicit ReferenceCampaign(const std::string& case_text);
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "run";
  std::filesystem::path case_ = folder_.path() / "crash_mill.toml";
};

inline constexpr double reversal_hours = 3000.0;

/// The command that starts a campaign and resumes it.
[[nodiscard]] std::vector<std::string> run_into(const std::filesystem::path& campaign,
                                                const std::filesystem::path& mill = case_file);

/// Puts an mpirun into a new folder that is a shell script, in which `mpirun` is the true one.
/// Returns the PATH with which it is found first.
std::string put_mpirun(const std::filesystem::path& folder, const std::string& script);

/// Expects that the same command ends well now, and leaves what the undisturbed campaign left.
void expect_resumes_to_the_same(const std::filesystem::path& campaign);

/// Expects that a stage is neither published nor in the ledger.
void expect_not_published(const std::filesystem::path& campaign, const StageName& stage);

}  // namespace millwear::crash
