#include "orchestrator/app/export_verb.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "meshgen/stl_file.h"
#include "mill/base/failure.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/campaign/run_lock.h"
#include "orchestrator/loads/cycle_load.h"
#include "orchestrator/loads/kept_file.h"
#include "orchestrator/results/gather.h"
#include "orchestrator/results/result_files.h"
#include "tests/support/sample_frames.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vtp_reader.h"
#include "wear/charge/charge_record.h"

namespace millwear::orchestrator {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr int steps_of_cycle = 5;

/// A campaign of two cycles without a DEM, of which the second has a charge.
class ExportVerb : public testing::Test {
 protected:
  ExportVerb() : run(synthetic_run(place.path(), 2)) {
    const RunFolder& folder = run.campaign.folder;
    add_charge(1);
    put_text(folder.locked_case(), locked_case_text(run.campaign.mill));
    write_ledger(folder.ledger(), run.ledger);
    publish_results(run.campaign, run.ledger, gather(run.campaign, run.ledger));
    for (int cycle = 0; cycle < 2; ++cycle)
      fs::remove_all(kept_file(folder, cycle, "").parent_path());
  }

  void add_charge(int cycle) {
    const StageId dem{cycle, StageKind::dem};
    const fs::path file = run.campaign.folder.stage(dem) / stage_files::charge;
    wear::write_charge(file, {wear::no_charge_fields({0.5, 8}, 0.2, 3), wear::sample_frames()});
    for (auto& entry : run.ledger.entries)
      if (entry.stage == dem) entry.outputs[stage_files::charge] = hash_of_file(file);
  }

  [[nodiscard]] ExportOptions asked() const {
    ExportOptions made;
    made.common.case_file = run.campaign.folder.locked_case();
    made.out = place.path();
    return made;
  }

  /// Exports for ParaView into `viewer`.
  std::string to_paraview(LinerExtent extent = LinerExtent::ring) const {
    ExportOptions wanted = asked();
    wanted.paraview = viewer;
    wanted.extent = extent;
    return printed(wanted);
  }

  /// What goes to standard output and error.
  static std::string printed(const ExportOptions& wanted) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    export_verb(wanted);
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
  }

  ReadVtp read(const char* file) const { return read_vtp(text_of(viewer / file)); }

  const TemporaryFolder place;
  const TemporaryFolder elsewhere;
  const fs::path viewer = elsewhere.path() / "viewer";
  SyntheticRun run;
};

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    files[entry.path().string()] = entry.is_regular_file() ? text_of(entry.path()) : "";
  return files;
}

TEST_F(ExportVerb, NamesEveryStepInTheSeriesOfTheLiner) {
  to_paraview();
  const std::string series = text_of(viewer / "liner.pvd");
  EXPECT_THAT(series, HasSubstr("timestep=\"0\" part=\"0\" file=\"liner/cycle_000_step_000.vtp\""));
  EXPECT_THAT(series,
              HasSubstr("timestep=\"600\" part=\"0\" file=\"liner/cycle_001_step_001.vtp\""));
  std::size_t files = 0;
  for (auto at = series.find("<DataSet"); at != std::string::npos;
       at = series.find("<DataSet", at + 1))
    ++files;
  EXPECT_EQ(files, 2U * steps_of_cycle + 1U);
  const ReadVtp last = read("liner/cycle_001_step_005.vtp");
  EXPECT_THAT(last["FieldData/operating_hours"], Contains(testing::DoubleNear(1000.0, 1e-6)));
}

// The synthetic lifters lose a tenth of their height of 40 mm over the campaign.
TEST_F(ExportVerb, GivesTheLinerItsWearAndItsLoad) {
  to_paraview();
  const ReadVtp first = read("liner/cycle_000_step_000.vtp");
  const ReadVtp last = read("liner/cycle_001_step_005.vtp");
  EXPECT_THAT(first["CellData/wear_depth_m"], testing::Each(testing::Lt(1e-6)));
  EXPECT_NEAR(std::ranges::max(last["CellData/wear_depth_m"]), 0.004, 5e-4);
  const auto all = load_of_cycle(run.campaign, 0).along.sliding_work.raw;
  EXPECT_NEAR(std::ranges::max(first["CellData/sliding_work_w_per_m2"]), std::ranges::max(all),
              1e-5 * std::ranges::max(all));
  for (const char* const name : {"CellData/wear_rate_mm_per_1000_h",
                                 "CellData/normal_dissipation_w_per_m2", "CellData/contacts_per_m"})
    EXPECT_EQ(last[name].size(), last["Polys/offsets"].size()) << name;
}

TEST_F(ExportVerb, PutsTheChargeAtTheHoursOfItsMeasurement) {
  to_paraview();
  EXPECT_THAT(text_of(viewer / "charge.pvd"),
              HasSubstr("timestep=\"500\" part=\"0\" file=\"charge/cycle_001_frame_00.vtp\""));
  EXPECT_THAT(text_of(viewer / "charge_cycle_001.pvd"),
              HasSubstr("timestep=\"0.15\" part=\"0\" file=\"charge/cycle_001_frame_01.vtp\""));
  EXPECT_EQ(read("charge/cycle_001_frame_00.vtp")["PointData/velocity_m_per_s"].size(), 6U);
}

// The mill turns by 0.25 rad from the mesh to the first frame, and as much to the second.
TEST_F(ExportVerb, TurnsTheLinerWithTheCharge) {
  to_paraview();
  const auto angle = [&](const char* file) {
    const auto points = read(file)["Points/Points"];
    return std::atan2(-points[0], -points[2]);
  };
  const double at_start = angle("liner/cycle_000_step_005.vtp");
  EXPECT_NEAR(angle("liner/cycle_001_frame_00.vtp") - at_start, 0.25, 1e-6);
  EXPECT_NEAR(angle("liner/cycle_001_frame_01.vtp") - at_start, 0.5, 1e-6);
  EXPECT_NEAR(angle("liner/cycle_001_step_001.vtp") - at_start, 0.25, 1e-3);
}

TEST_F(ExportVerb, WritesOneLifterWhereAsked) {
  to_paraview();
  const auto ring = read("liner/cycle_000_step_000.vtp")["Polys/offsets"].size();
  to_paraview(LinerExtent::one_lifter);
  EXPECT_EQ(12 * read("liner/cycle_000_step_000.vtp")["Polys/offsets"].size(), ring);
}

TEST_F(ExportVerb, SaysWhatIsMissingAndHowToGetIt) {
  const std::string said = to_paraview();
  EXPECT_THAT(said, HasSubstr("no charge of cycle 0: "));
  EXPECT_THAT(said, HasSubstr("`millwear run` into another folder (--out) measures the cycles"));
  EXPECT_THAT(said, Not(HasSubstr("no loads")));
}

// As of the kept campaigns of cases/*/reference.
TEST_F(ExportVerb, ShowsTheLinerOfTablesAlone) {
  const TemporaryFolder tables;
  for (const char* const name : {"history.csv", "profiles.csv"})
    fs::copy_file(run.campaign.folder.results() / name, tables.path() / name);
  fs::copy_file(run.campaign.folder.locked_case(), tables.path() / "case.lock.toml");
  fs::copy_file(run.campaign.folder.ledger(), tables.path() / "ledger.jsonl");
  ExportOptions wanted = asked();
  wanted.out = tables.path();
  wanted.paraview = viewer;
  EXPECT_THAT(printed(wanted), HasSubstr("no loads on the liner of cycles 0 to 1"));
  EXPECT_FALSE(fs::exists(viewer / "charge.pvd"));
  EXPECT_FALSE(read("liner/cycle_001_step_005.vtp").arrays.contains("CellData/contacts_per_m"));
}

TEST_F(ExportVerb, RemovesTheSeriesOfAnEarlierExportAlone) {
  fs::create_directory(viewer);
  for (const char* const name : {"charge_cycle_009.pvd", "charge.pvd", "mine.pvd", "liner.png"})
    put_text(viewer / name, "earlier");
  to_paraview();
  EXPECT_FALSE(fs::exists(viewer / "charge_cycle_009.pvd"));
  EXPECT_NE(text_of(viewer / "charge.pvd"), "earlier");
  EXPECT_EQ(text_of(viewer / "mine.pvd"), "earlier");
  EXPECT_EQ(text_of(viewer / "liner.png"), "earlier");
}

// The lock is held as by a `run` at work.
TEST_F(ExportVerb, LeavesARunningCampaignAsItIs) {
  const RunLock running(run.campaign.folder.lock());
  const auto before = files_below(place.path());
  EXPECT_NO_THROW(to_paraview());
  EXPECT_TRUE(files_below(place.path()) == before);
}

TEST_F(ExportVerb, RefusesALoadThatWasChanged) {
  const auto load = run.campaign.folder.stage({0, StageKind::dem}) / stage_files::load;
  put_text(load, text_of(load) + "x");
  ExportOptions wanted = asked();
  wanted.paraview = viewer;
  EXPECT_THAT(failure_of<ResultRejected>([&] { export_verb(wanted); }), HasSubstr("was changed"));
  EXPECT_FALSE(fs::exists(viewer / "liner.pvd"));
}

TEST_F(ExportVerb, WritesTheProfileOfAStep) {
  ExportOptions wanted = asked();
  wanted.cycle = 0;
  wanted.at_step = 2;
  wanted.csv = elsewhere.path() / "profile.csv";
  wanted.dxf = elsewhere.path() / "profile.dxf";
  EXPECT_THAT(printed(wanted), HasSubstr("cycle 0, step 2, 200 h: "));
  const auto kept = read_cycle(run.campaign.folder.stage({0, StageKind::wear}) / stage_files::steps,
                               run.campaign.mill.liner.sector);
  EXPECT_EQ(read_profile_nodes(*wanted.csv), kept.steps[1].profile.nodes);
  EXPECT_THAT(text_of(*wanted.dxf), HasSubstr("LINER"));
}

// The worn liners of the synthetic run do not meet at the sector's edges.
TEST_F(ExportVerb, WritesMeshAndSolid) {
  ExportOptions wanted = asked();
  wanted.cycle = 0;
  wanted.at_step = 0;
  wanted.stl = elsewhere.path() / "liner.stl";
  wanted.step = elsewhere.path() / "liner.step";
  printed(wanted);
  EXPECT_FALSE(meshgen::read_stl(*wanted.stl).empty());
  EXPECT_THAT(text_of(*wanted.step), testing::StartsWith("ISO-10303-21"));
}

TEST_F(ExportVerb, OfAStepThatIsNotThereWritesNothing) {
  ExportOptions wanted = asked();
  wanted.at_step = 7;
  wanted.csv = elsewhere.path() / "profile.csv";
  wanted.paraview = viewer;
  EXPECT_THAT(failure_of<Failure>([&] { export_verb(wanted); }),
              HasSubstr("cycle 1 has steps 1 to 5"));
  EXPECT_TRUE(fs::is_empty(elsewhere.path()));
}

TEST_F(ExportVerb, IntoAFolderThatCannotBeFailsOnTheDisk) {
  put_text(elsewhere.path() / "file", "");
  ExportOptions wanted = asked();
  wanted.paraview = elsewhere.path() / "file" / "viewer";
  EXPECT_NE(failure_of<DiskError>([&] { export_verb(wanted); }), "");
  wanted.paraview = place.path() / "viewer";
  EXPECT_THAT(failure_of<Failure>([&] { export_verb(wanted); }),
              HasSubstr("among the campaign's own files"));
}

TEST_F(ExportVerb, SaysWhatGoesWithWhat) {
  EXPECT_THAT(failure_of<Failure>([&] { export_verb(asked()); }), HasSubstr("export what?"));
  ExportOptions choice = asked();
  choice.paraview = viewer;
  choice.cycle = 0;
  EXPECT_THAT(failure_of<Failure>([&] { export_verb(choice); }), HasSubstr("has all steps"));
  ExportOptions lifter = asked();
  lifter.csv = elsewhere.path() / "profile.csv";
  lifter.extent = LinerExtent::one_lifter;
  EXPECT_THAT(failure_of<Failure>([&] { export_verb(lifter); }), HasSubstr("is for --paraview"));
}

TEST_F(ExportVerb, PrintsJson) {
  ExportOptions wanted = asked();
  wanted.common.form = OutputForm::json;
  wanted.paraview = viewer;
  wanted.csv = elsewhere.path() / "profile.csv";
  const std::string text = printed(wanted);
  EXPECT_THAT(text, HasSubstr("\"file\": \"charge_cycle_001.pvd\""));
  EXPECT_THAT(text, HasSubstr("\"operating_hours\": 1000.0"));
}

}  // namespace
}  // namespace millwear::orchestrator
