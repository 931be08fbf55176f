#include <gmock/gmock.h>

#include "tests/crash/reference_campaign.h"

namespace millwear::crash {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

enum class ContactsBy { recorder, dumps };

/// A run of LIGGGHTS that looks like a success and is none.
struct StandIn {
  const char* name;
  StageName stage;
  const char* script;  ///< of an mpirun; `run` runs the real one
  const char* where;   ///< the file or stage that the message must name
  const char* why;     ///< that the message must say
  ContactsBy contacts = ContactsBy::recorder;
};

void PrintTo(const StandIn& stand_in, std::ostream* out) { *out << stand_in.name; }

// A dump that is spoilt is written as a file first and then into the pipe.
const StandIn stand_ins[] = {
    {"ends_half_way", "cycle_000/mix",
     "sed -i 's/^run .*/run 40/; /^print/d; /^write_restart/d' deck.in; run", "liggghts.log",
     "stopped half way, its last step was 40 of"},
    {"ends_at_an_error", "cycle_000/mix", "sed -i 's/^run .*/runaway/' deck.in; run",
     "liggghts.log", "LIGGGHTS stopped: ERROR"},
    {"prints_nothing", "cycle_000/mix", "true", "liggghts.log", "stopped half way"},
    {"forgets_the_last_line", "cycle_000/mix", "run | grep -v 'stretch complete'", "liggghts.log",
     "stopped half way"},
    {"loses_an_atom", "cycle_000/mix", "run | sed -E 's/^( +[0-9]{3} +)32 /\\131 /'",
     "liggghts.log", "31 of 32 particles are left at step"},
    {"reads_half_the_mesh", "cycle_000/mix",
     "run | sed 's/containing [0-9]* tri/containing 66 tri/'", "liggghts.log",
     "LIGGGHTS read 66 of the mesh's"},
    {"explodes", "cycle_000/mix", "run | sed -E 's/^( +[0-9]{3} +32 +)[^ ]+/\\1nan/'",
     "liggghts.log", "not finite"},
    {"writes_an_empty_restart", "cycle_000/mix", "run; : > charge.restart", "charge.restart",
     "too short for 32 particles"},
    {"writes_no_restart", "cycle_000/mix", "run; rm charge.restart", "charge.restart",
     "too short for 32 particles"},
    {"cuts_a_row", "cycle_000/dem",
     "sed -i 's/contacts.dump/whole/' deck.in; run; head -c -9 whole > contacts.dump",
     "contacts.dump", "ends inside the snapshot of step 3315", ContactsBy::dumps},
    {"drops_the_last_snapshot", "cycle_000/dem",
     "sed -i 's/contacts.dump/whole/' deck.in; run;"
     "head -n $(($(grep -n TIMESTEP whole | tail -1 | cut -d: -f1) - 1)) whole > contacts.dump",
     "cycle 0 dem: ", "do not hold the same steps (step 3315)", ContactsBy::dumps},
    {"writes_no_dump", "cycle_000/dem", "sed -i 's/spins.dump/whole/' deck.in; run",
     "cycle 0 dem: ", "do not hold the same steps", ContactsBy::dumps},
    {"writes_letters_for_numbers", "cycle_000/dem",
     "sed -i 's/contacts.dump/whole/' deck.in; run;"
     "awk 'NF > 9 && $1 != \"ITEM:\" && !n++ { $1 = \"x\" $1 } { print }' whole > contacts.dump",
     "contacts.dump", "number", ContactsBy::dumps},
    {"cuts_the_torque", "cycle_000/dem", "run; sed -i '$d' torque.txt; sed -i '$d' torque.txt",
     "torque.txt", "ends at step"},
    {"records_less_than_it_was_told", "cycle_000/dem",
     "sed -i '/^run .*[1-9]/d; /^print/i print \"stretch complete\"' deck.in; run", "liggghts.log",
     "LIGGGHTS stopped: ERROR: "},
    {"leaves_no_load", "cycle_000/dem", "run; rm load.h5", "liggghts.log",
     "the recorder left no load.h5"},
    {"leaves_no_events", "cycle_000/dem", "run; rm events.h5", "liggghts.log",
     "the recorder left no events.h5"},
    {"cuts_the_load", "cycle_000/dem", "run; truncate -s -999 load.h5", "load.h5", "damaged"},
};

class LiggghtsThat : public testing::TestWithParam<StandIn> {};

TEST_P(LiggghtsThat, IsNotBelieved) {
  const auto& [name, stage, script, where, why, contacts] = GetParam();
  const TemporaryFolder folder;
  const fs::path campaign = folder.path() / "run";
  const auto& reference =
      contacts == ContactsBy::recorder ? ReferenceCampaign::get() : ReferenceCampaign::of_dumps();
  reference.copy_up_to(stage, campaign);
  const std::string path =
      put_mpirun(folder.path() / "programs", "arguments=\"$*\"\nrun() { mpirun $arguments; }\n" +
                                                 std::string(script) + "\nexit 0");

  const Ended ended = millwear(run_into(campaign, reference.mill()), {.path = path});
  EXPECT_EQ(ended.code, 5);
  EXPECT_THAT(ended.err, AllOf(HasSubstr(where), HasSubstr(why)));
  expect_not_published(campaign, stage);
  EXPECT_THAT(survivors_in(campaign), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Crash, LiggghtsThat, testing::ValuesIn(stand_ins),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace millwear::crash
