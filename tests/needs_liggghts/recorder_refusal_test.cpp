#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <tuple>

#include "liggghts_inputs/decks/deck.h"
#include "mill/case/time_step.h"
#include "mill/case_file/case_lock.h"
#include "mill/liner/profile_csv.h"
#include "orchestrator/dem_run/stretch_run.h"
#include "tests/needs_liggghts/mill_trial.h"
#include "wear/record/collision_store.h"
#include "wear/record/load_read.h"

namespace millwear::trial {
namespace {

namespace fs = std::filesystem;
namespace names = liggghts::file_names;
using liggghts::StretchSteps;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* mix_stage = "mix";
constexpr int disk = 6;
constexpr int bad_input = 3;
constexpr int rejected = 5;
constexpr int usage = 2;

Case recorded_mill() { return small_mill(ContactPath::recorder); }

/// The small mill's mixed charge, made once for all tests.
const ScratchFolder& mixed() {
  static const ScratchFolder folder;
  static const bool made = [] {
    const Case mill = recorded_mill();
    const auto plan = plan_steps(mill);
    mix(mill, {plan.time_step, plan.steps_per_pitch, 0, 20}, folder.stage(mix_stage), 1);
    return true;
  }();
  static_cast<void>(made);
  return folder;
}

struct Ended {
  int code;
  std::string log;
};

class RecorderRefusal : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!liggghts_is_installed()) GTEST_SKIP() << "liggghts or mpirun is not installed";
    fs::copy(mixed().stage(mix_stage), folder_.parent_path() / mix_stage);
    write_stage(mill_);
  }

  /// What a stretch of a mill needs.
  void write_stage(const Case& mill) {
    const auto mesh = write_liner_mesh(mill, mill.liner, folder_);
    write_text(folder_ / names::deck,
               liggghts::measuring_deck(mill, steps_, mill.liner,
                                        fmt::format("../{}/{}", mix_stage, names::restart), 1));
    write_text(folder_ / names::contact_model,
               liggghts::contact_model_deck(mill, steps_, {"liner.stl", mesh.triangles.size()},
                                            {liggghts::StretchKind::measure, 0}));
    write_text(folder_ / "case.toml", locked_case_text(mill));
    write_text(folder_ / "liner.csv", profile_csv(mill.liner));
  }

  void change(const char* file, const std::string& old, const std::string& by) const {
    std::string text = text_of(folder_ / file);
    const auto place = text.find(old);
    ASSERT_NE(place, std::string::npos) << old;
    write_text(folder_ / file, text.replace(place, old.size(), by));
  }

  /// Takes a command out of a deck with the lines that go on with it.
  void drop(const char* file, const std::string& command) const {
    std::string text = text_of(folder_ / file);
    const auto start = text.find("\n" + command);
    ASSERT_NE(start, std::string::npos) << command;
    auto end = text.find('\n', start + 1);
    while (text[end - 1] == '&') end = text.find('\n', end + 1);
    write_text(folder_ / file, text.erase(start, end - start));
  }

  [[nodiscard]] Ended run(const std::map<std::string, std::string>& other = {}, int ranks = 1,
                          const std::function<void(std::string_view)>& take_line = {}) const {
    std::map<std::string, std::string> options = {{"--in", names::deck},
                                                  {"--case", "case.toml"},
                                                  {"--liner", "liner.csv"},
                                                  {"--load", "load.h5"},
                                                  {"--events", "events.h5"},
                                                  {"--after", std::to_string(steps_.settle_steps)},
                                                  {"--until", std::to_string(steps_.total())}};
    for (const auto& [option, value] : other) options[option] = value;
    std::vector<std::string> arguments;
    for (const auto& [option, value] : options) arguments.insert(arguments.end(), {option, value});
    const int code = orchestrator::run_liggghts(
        {folder_, ranks, take_line, orchestrator::RecorderProgram{MILLWEAR_RECORDER, arguments}},
        {});
    return {code, text_of(folder_ / names::log)};
  }

  [[nodiscard]] std::vector<std::string> results() const {
    std::vector<std::string> found;
    for (const auto& file : fs::directory_iterator(folder_)) {
      const std::string name = file.path().filename();
      if (name.find("load") != std::string::npos || name.find("events") != std::string::npos)
        found.push_back(name);
    }
    return found;
  }

  void expect_refused(const Ended& ended, int code, const std::string& why) const {
    EXPECT_EQ(ended.code, code);
    EXPECT_THAT(ended.log, AllOf(HasSubstr("ERROR: "), HasSubstr(why)));
    EXPECT_THAT(results(), IsEmpty());
  }

  Case mill_ = recorded_mill();
  const StretchSteps steps_{plan_steps(mill_).time_step, 200, 400, 1};
  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.stage("dem");
};

TEST_F(RecorderRefusal, OfADeckWithoutAMeshNamesTheDeck) {
  drop(names::contact_model, "fix turn_");
  drop(names::contact_model, "fix wall");
  drop(names::contact_model, "fix liner");
  drop(names::contact_model, "variable torque");
  change(names::deck, " v_torque\n", "\n");
  expect_refused(run(), bad_input,
                 "deck.in with case.toml: the deck has no `fix mesh/surface`, so there is no wall");
}

TEST_F(RecorderRefusal, OfAMeshThatNothingTouches) {
  drop(names::contact_model, "fix wall");
  expect_refused(run(), bad_input, "no `fix wall/gran ... mesh` uses the mesh `liner");
}

TEST_F(RecorderRefusal, OfTwoMeshes) {
  change(names::contact_model, "fix wall",
         "fix lid all mesh/surface file liner.stl type 1 curvature 1e-5\nfix wall");
  expect_refused(run(), bad_input, "more than one `fix mesh/surface`; give the liner in one");
}

class RecorderRefusalOfCommand : public RecorderRefusal,
                                 public ::testing::WithParamInterface<const char*> {};

// With these a deck does something else where it is given line by line.
TEST_P(RecorderRefusalOfCommand, NamesFileAndLine) {
  const std::string line = GetParam();
  const std::string command = line.substr(0, line.find(' '));
  change(names::contact_model, "fix wall", line + "\nfix wall");
  expect_refused(run(), bad_input,
                 fmt::format("contact_model.in: `{}`: the recorder runs a deck from top to bottom; "
                             "write the deck without `{}`",
                             line, command));
}

INSTANTIATE_TEST_SUITE_P(Recorder, RecorderRefusalOfCommand,
                         ::testing::Values("jump deck.in again", "label again", "next i",
                                           "if \"1 > 0\" then \"run 10\"", "clear", "quit"),
                         [](const auto& tested) {
                           const std::string line = tested.param;
                           return line.substr(0, line.find(' '));
                         });

TEST_F(RecorderRefusal, OfADeckWithoutARun) {
  for (const auto& command : {"reset_timestep", "run", "run"}) drop(names::deck, command);
  expect_refused(run(), bad_input, "deck.in: the deck has no `run`");
}

TEST_F(RecorderRefusal, OfADeckThatEndsBeforeTheMeasurement) {
  const long too_far = steps_.total() + 1;
  expect_refused(run({{"--until", std::to_string(too_far)}}), rejected,
                 "the deck ended at step 600 and gave 400 samples of the wall contacts, not 401");
}

// A step that the deck does twice would count twice.
TEST_F(RecorderRefusal, OfADeckThatCountsItsStepsAnewInTheMeasurement) {
  change(names::deck, "write_restart", "reset_timestep 200\nrun 400\nwrite_restart");
  expect_refused(run(), rejected, "gave 800 samples of the wall contacts, not 400");
}

TEST_F(RecorderRefusal, OfACaseWithAnotherCharge) {
  Case other = mill_;
  other.charge.classes.front().count += 1;
  write_text(folder_ / "case.toml", locked_case_text(other));
  expect_refused(run(), bad_input,
                 "deck.in with case.toml: the deck has 120 particles and the case 121");
}

TEST_F(RecorderRefusal, OfACaseWithOtherParticles) {
  Case other = mill_;
  other.charge.classes.front().diameter = 0.028;
  write_text(folder_ / "case.toml", locked_case_text(other));
  expect_refused(run(), rejected, "is of no class of the charge");
}

TEST_F(RecorderRefusal, OfACaseWithAnotherSpeed) {
  Case other = mill_;
  other.speed *= 1.01;
  write_text(folder_ / "case.toml", locked_case_text(other));
  expect_refused(run(), bad_input, "m/s where the case's speed makes");
}

TEST_F(RecorderRefusal, OfADeckThatDoesNotFindParticlesByNumber) {
  drop(names::deck, "atom_modify");
  expect_refused(run(), bad_input, "the deck needs `atom_modify map array`");
}

TEST_F(RecorderRefusal, OfAnErrorOfLiggghts) {
  change(names::deck, "reset_timestep", "reset_timesteps");
  expect_refused(run(), 1, "reset_timesteps");
}

TEST_F(RecorderRefusal, OfACommandLineThatDoesNotFit) {
  expect_refused(run({{"--until", "200"}}), usage, "--until 200 has to lie after --after 200");
  expect_refused(run({{"--evry", "2"}}), usage, "--evry");
  expect_refused(run({{"--pairs-after", "250"}}), bad_input,
                 "--pairs-after 250: no `run` of the deck begins at that step");
}

// 400 steps in ten blocks; the deck's last run ends at step 600.
TEST_F(RecorderRefusal, OfAMeasurementThatCannotGoOnAsTold) {
  expect_refused(run({{"--target-error", "0.05"}, {"--go-on-by", "30"}, {"--at-most", "660"}}),
                 bad_input, "--go-on-by 30 makes no whole time blocks");
  expect_refused(run({{"--until", "590"},
                      {"--target-error", "0.05"},
                      {"--go-on-by", "39"},
                      {"--at-most", "629"}}),
                 bad_input, "--until 590: no `run` of the deck ends at that step");
}

TEST_F(RecorderRefusal, OfAMissingFileNamesIt) {
  expect_refused(run({{"--case", "mine.toml"}}), bad_input, "mine.toml");
  expect_refused(run({{"--liner", "mine.csv"}}), bad_input, "mine.csv");
  change(names::deck, std::string("include       ") + names::contact_model, "include mine.in");
  expect_refused(run(), bad_input, "mine.in: there is no such deck");
  expect_refused(run({{"--load", "gone/load.h5"}}), disk, "gone/load.h5: there is no folder");
}

// What is left of an earlier recording must not be taken for the result of one that failed.
TEST_F(RecorderRefusal, LeavesNoOlderResult) {
  for (const auto& name : {"load.h5", "events.h5", "events.h5.rank1", "events.h5.rank2"})
    write_text(folder_ / name, "old");
  drop(names::deck, "atom_modify");
  expect_refused(run(), bad_input, "atom_modify");
}

class FullDisk : public RecorderRefusal, public ::testing::WithParamInterface<const char*> {};

// /dev/full takes nothing: in place of the spool, of the events and of the load.
TEST_P(FullDisk, IsNamedAndNothingIsPublished) {
  fs::create_symlink("/dev/full", folder_ / GetParam());
  const Ended ended = run();
  EXPECT_EQ(ended.code, disk);
  EXPECT_THAT(ended.log, AllOf(HasSubstr("ERROR: "), HasSubstr("disk full?")));
  EXPECT_FALSE(fs::exists(folder_ / "load.h5"));
  EXPECT_FALSE(fs::exists(folder_ / "events.h5.rank0"));
}

INSTANTIATE_TEST_SUITE_P(Recorder, FullDisk,
                         ::testing::Values("events.h5.rank0", ".events.partial.h5",
                                           ".load.partial.h5"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::erase_if(name, [](char c) { return c == '.'; });
                           return name;
                         });

/// Ranks of the recorder that work in a folder.
std::vector<int> ranks_in(const fs::path& folder) {
  std::vector<int> found;
  for (const auto& process : fs::directory_iterator("/proc")) {
    const std::string name = process.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::error_code gone;
    const auto works_in = fs::read_symlink(process.path() / "cwd", gone);
    if (!gone && works_in == folder && text_of(process.path() / "comm") == "millwear-record\n")
      found.push_back(std::stoi(name));
  }
  return found;
}

TEST_F(RecorderRefusal, OfTheResultWhereARankIsKilled) {
  change(names::deck, "thermo        ", "thermo        100 #");
  bool killed = false;
  const Ended ended = run({}, 2, [&](std::string_view line) {
    if (killed || !line.starts_with("     300 ")) return;
    const auto ranks = ranks_in(folder_);
    ASSERT_EQ(ranks.size(), 2u);
    ::kill(ranks.back(), SIGKILL);
    killed = true;
  });
  EXPECT_TRUE(killed) << ended.log;
  EXPECT_NE(ended.code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "load.h5"));
  EXPECT_FALSE(fs::exists(folder_ / "events.h5"));
  // The same command leaves its results and nothing else.
  EXPECT_EQ(run({}, 1).code, 0);
  EXPECT_THAT(results(), testing::UnorderedElementsAre("load.h5", "events.h5"));
}

class TwoHalves : public RecorderRefusal {
 protected:
  struct Part {
    wear::LinerRecord record;
    std::vector<wear::Collision> collisions;
  };

  [[nodiscard]] Part recorded(long after, long until) const {
    return recorded({{"--after", std::to_string(after)}, {"--until", std::to_string(until)}});
  }

  /// The steps from `after` to `until` as a part of a measurement of all of them.
  [[nodiscard]] Part recorded_part(long after, long until) const {
    return recorded({{"--after", std::to_string(after)},
                     {"--until", std::to_string(until)},
                     {"--measured-before", std::to_string(after)},
                     {"--block-steps", std::to_string(steps_.total())}});
  }

  [[nodiscard]] Part recorded(const std::map<std::string, std::string>& options) const {
    const Ended ended = run(options);
    EXPECT_EQ(ended.code, 0) << ended.log;
    Part part{wear::read_record(folder_ / "load.h5"), {}};
    wear::for_each_collision(folder_ / "events.h5", [&](const wear::Collision& collision) {
      part.collisions.push_back(collision);
    });
    return part;
  }

  static long flagged(const Part& part, wear::Unfinished flag) {
    return std::ranges::count_if(part.collisions, [&](const wear::Collision& collision) {
      return (static_cast<int>(collision.unfinished) & static_cast<int>(flag)) != 0;
    });
  }
};

// One run of 2 N steps, measured in one go and in two: every sum is the sum of both, and what is
// cut in two is flagged in both and makes the whole again. What touches where a measurement begins
// with the run itself is flagged too, and no impact.
TEST_F(TwoHalves, MakeTheWhole) {
  const long middle = steps_.settle_steps;
  const long end = steps_.total();
  const Part whole = recorded(0, end);
  const Part first = recorded(0, middle);
  const Part second = recorded(middle, end);
  for (std::size_t m = 0; m < measure_count; ++m) {
    const auto measure = static_cast<Measure>(m);
    const double sum =
        first.record.load.total(measure).sum() + second.record.load.total(measure).sum();
    const double all = whole.record.load.total(measure).sum();
    EXPECT_NEAR(sum, all, 1e-9 * std::abs(all)) << measure_names[m];
  }

  const long cut = flagged(first, wear::Unfinished::open_at_end);
  EXPECT_GT(cut, 0);
  EXPECT_EQ(flagged(second, wear::Unfinished::began_before), cut);
  EXPECT_GT(flagged(first, wear::Unfinished::began_before), 0);
  EXPECT_EQ(flagged(first, wear::Unfinished::began_before),
            flagged(whole, wear::Unfinished::began_before));
  EXPECT_EQ(flagged(second, wear::Unfinished::open_at_end),
            flagged(whole, wear::Unfinished::open_at_end));
  EXPECT_EQ(first.collisions.size() + second.collisions.size() - static_cast<std::size_t>(cut),
            whole.collisions.size());
  EXPECT_EQ(whole.record.load.total(Measure::events).sum() +
                static_cast<double>(flagged(whole, wear::Unfinished::began_before)),
            static_cast<double>(whole.collisions.size()));

  // A collision that neither half cuts is the same to the bit, but for the clock of the second.
  using Key = std::tuple<std::uint32_t, double, double>;
  std::map<Key, double> works;
  for (const auto& c : whole.collisions)
    works[{c.particle, c.arc_length, c.impact_speed}] = c.sliding_work;
  std::size_t same = 0;
  for (const auto* part : {&first, &second})
    for (const auto& c : part->collisions) {
      if (c.unfinished != wear::Unfinished::none) continue;
      const auto found = works.find({c.particle, c.arc_length, c.impact_speed});
      ASSERT_NE(found, works.end());
      EXPECT_NEAR(found->second, c.sliding_work, 1e-9 * std::abs(c.sliding_work));
      ++same;
    }
  EXPECT_GT(same, 0u);
}

// Recorded as parts of one measurement, they join to it block by block, on one clock, wherever its
// time blocks end.
TEST_F(TwoHalves, JoinAsPartsOfOneMeasurement) {
  const long middle = steps_.settle_steps;
  const long end = steps_.total();
  const Part whole = recorded(0, end);
  const Part first = recorded_part(0, middle);
  const Part second = recorded_part(middle, end);
  const wear::LinerRecord joined = wear::joined(first.record, second.record);
  EXPECT_EQ(joined.load.duration, whole.record.load.duration);
  for (std::size_t m = 0; m < measure_count; ++m) {
    const auto& mine = joined.load.values[m];
    const auto& theirs = whole.record.load.values[m];
    ASSERT_EQ(mine.cols(), theirs.cols());
    EXPECT_LT((mine - theirs).cwiseAbs().maxCoeff(), 1e-9 * theirs.cwiseAbs().maxCoeff())
        << measure_names[m];
  }
  EXPECT_LT((joined.motion->census - whole.record.motion->census).cwiseAbs().maxCoeff(),
            1e-9 * whole.record.motion->census.maxCoeff());
  EXPECT_DOUBLE_EQ(second.collisions.back().end, whole.collisions.back().end);
}

}  // namespace
}  // namespace millwear::trial
