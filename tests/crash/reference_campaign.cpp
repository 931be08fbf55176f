#include "tests/crash/reference_campaign.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The value of a key in a line of the ledger, up to the next comma.
std::string value_in(const std::string& line, const std::string& key) {
  const auto start = line.find("\"" + key + "\":") + key.size() + 3;
  return line.substr(start, line.find_first_of(",}", start) - start);
}

/// The stage that a line of the ledger tells of.
StageName stage_in(const std::string& line) {
  const std::string cycle = value_in(line, "cycle");
  const std::string kind = value_in(line, "stage");
  return "cycle_" + std::string(3 - cycle.size(), '0') + cycle + "/" +
         kind.substr(1, kind.size() - 2);
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void put_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "millwear_crash_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = fs::canonical(name);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code problem;
  fs::remove_all(path_, problem);
}

fs::path partial_of(const fs::path& campaign, const StageName& stage) {
  const fs::path published = campaign / stage;
  return published.parent_path() / ("." + published.filename().string() + ".partial");
}

/// The crash mill for two cycles, with these lines at the end of its [campaign].
std::string two_cycles(const std::string& lines) {
  const std::string limit = "cycle_limit = 20";
  std::string text = text_of(case_file);
  return text.replace(text.find(limit), limit.size(), "cycle_limit = 2\n" + lines);
}

const ReferenceCampaign& ReferenceCampaign::get() {
  static const ReferenceCampaign reference(text_of(case_file));
  if (reference.stages().size() != 10)
    throw std::runtime_error("the undisturbed campaign took other than three cycles");
  return reference;
}

const ReferenceCampaign& ReferenceCampaign::of_dumps() {
  static const ReferenceCampaign reference([] {
    std::string text = text_of(case_file);
    for (const std::string recorded : {"keep_events = true\n", "pair_revolutions = 0.1\n"})
      text.erase(text.find(recorded), recorded.size());
    return text.insert(text.find("[dem]\n") + 6, "wall_contacts = \"dumps\"\n");
  }());
  return reference;
}

const ReferenceCampaign& ReferenceCampaign::of_a_reversal() {
  static const ReferenceCampaign reference(
      two_cycles("reversal_hours = [" + std::to_string(reversal_hours) + "]\n"));
  return reference;
}

const ReferenceCampaign& ReferenceCampaign::of_a_change() {
  static const ReferenceCampaign reference(
      two_cycles("[[campaign.operation]]\nfrom_hours = " + std::to_string(reversal_hours) +
                 "\nspeed_rpm = 40.0\ncounts = [18, 10]\n"));
  return reference;
}

ReferenceCampaign::ReferenceCampaign(const std::string& case_text) {
  put_text(case_, case_text);
  const Ended ended = millwear(run_into(path_, case_));
  if (ended.code != 0) throw std::runtime_error("the undisturbed campaign failed: " + ended.err);
}

std::vector<StageName> ReferenceCampaign::stages() const {
  const auto lines = lines_of(path_ / "ledger.jsonl");
  std::vector<StageName> names;
  for (std::size_t i = 1; i < lines.size(); ++i) names.push_back(stage_in(lines[i]));
  return names;
}

void ReferenceCampaign::copy_up_to(const StageName& stage, const fs::path& campaign) const {
  const auto lines = lines_of(path_ / "ledger.jsonl");
  fs::create_directories(campaign);
  fs::copy(path_ / "case.lock.toml", campaign);
  std::string ledger = lines[0] + "\n";
  for (std::size_t i = 1; stage_in(lines.at(i)) != stage; ++i) {
    ledger += lines[i] + "\n";
    const fs::path published = campaign / stage_in(lines[i]);
    fs::create_directories(published.parent_path());
    fs::copy(path_ / stage_in(lines[i]), published);
  }
  put_text(campaign / "ledger.jsonl", ledger);
}

void ReferenceCampaign::copy_to(const fs::path& campaign) const {
  fs::copy(path_, campaign, fs::copy_options::recursive);
}

std::vector<std::string> run_into(const fs::path& campaign, const fs::path& mill) {
  return {"run", mill.string(), "--out", campaign.string()};
}

std::string put_mpirun(const fs::path& folder, const std::string& script) {
  const std::string path = std::getenv("PATH");
  fs::create_directory(folder);
  put_text(folder / "mpirun", "#!/bin/sh\nPATH='" + path + "'\n" + script + "\n");
  fs::permissions(folder / "mpirun", fs::perms::owner_all);
  return folder.string() + ":" + path;
}

void expect_resumes_to_the_same(const fs::path& campaign) {
  const Ended ended = millwear(run_into(campaign));
  EXPECT_EQ(ended.code, 0) << ended.err;
  const auto& reference = ReferenceCampaign::get();
  for (const fs::path name :
       {"results/history.csv", "results/profiles.csv", "results/replicates.csv", "results/bins.h5",
        "results/spectra.csv", "cycle_002/dem/events.h5"})
    EXPECT_TRUE(text_of(campaign / name) == text_of(reference.path() / name))
        << name << " differs from the undisturbed campaign's";
  std::vector<StageName> stages;
  const auto lines = lines_of(campaign / "ledger.jsonl");
  for (std::size_t i = 1; i < lines.size(); ++i) stages.push_back(stage_in(lines[i]));
  EXPECT_EQ(stages, reference.stages());
  for (const auto& file : fs::recursive_directory_iterator(campaign)) {
    const std::string name = file.path().filename();
    EXPECT_TRUE(name.find(".partial") == std::string::npos &&
                name.find(".rank") == std::string::npos)
        << file.path();
  }
}

void expect_not_published(const fs::path& campaign, const StageName& stage) {
  EXPECT_FALSE(fs::exists(campaign / stage));
  const auto lines = lines_of(campaign / "ledger.jsonl");
  for (std::size_t i = 1; i < lines.size(); ++i) EXPECT_NE(stage_in(lines[i]), stage);
}

}  // namespace millwear::crash
