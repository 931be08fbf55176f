#include "recorder/run/build_check.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear::recorder {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// What LIGGGHTS 3.8.0 of Debian 12 says of itself, and what stands in its library.
constexpr const char* running =
    "LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32 by buildd, git commit unknown";
constexpr const char* built_for = "LIGGGHTS-PUBLIC 3.8.0, compiled 2022-01-26-19:42:32";

TEST(BuildCheck, TakesTheBuildThatItWasCompiledAgainst) {
  EXPECT_NO_THROW(check_build(built_for, running));
}

// The same version compiled anew may lay its classes out anew.
TEST(BuildCheck, RefusesAnyOtherAndNamesBoth) {
  for (const char* const other : {"LIGGGHTS-PUBLIC 3.8.0, compiled 2024-06-01-08:00:00",
                                  "LIGGGHTS-PUBLIC 3.7.0, compiled 2022-01-26-19:42:32", ""}) {
    try {
      check_build(other, running);
      FAIL() << other;
    } catch (const ExternalProgramError& problem) {
      EXPECT_EQ(problem.exit_code, ExitCode::external_program_failed);
      EXPECT_THAT(problem.what(), AllOf(HasSubstr(other), HasSubstr(running),
                                        HasSubstr("make build"), HasSubstr("\"dumps\"")));
    }
  }
}

}  // namespace
}  // namespace millwear::recorder
