#include "mill/case_file/case_edit.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "mill/base/failure.h"
#include "mill/case_file/case_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear {
namespace {

using testing::HasSubstr;

const std::filesystem::path cases(MILLWEAR_CASES);

CaseDocument pilot() { return read_case_document(cases / "pilot_mill" / "case.toml"); }
CaseDocument seed_mill() {
  return read_case_document(cases / "seed_mill_8m_desktop" / "case.toml");
}

CaseDocument edited(const CaseDocument& document, const char* key, const char* value) {
  return with_value(document, case_key_path(key), value_from_text(value, 7));
}

std::string refusal(const char* key, const CaseDocument& document) {
  return orchestrator::failure_of<InputError>(
      [&] { static_cast<void>(edited(document, key, "1")); });
}

TEST(CaseEdit, ChangesAKeyOfATable) {
  EXPECT_EQ(case_from_document(edited(pilot(), "mill.rows", "10")).liner.sector.rows, 10);
}

TEST(CaseEdit, AddsAKeyOrATableThatIsMissing) {
  EXPECT_EQ(case_from_document(edited(pilot(), "wear.time_blocks", "7")).wear.time_blocks, 7);
  EXPECT_EQ(case_from_document(edited(pilot(), "gauge.calibrate_until_hours", "100"))
                .gauge.calibrate_until,
            100.0);
}

TEST(CaseEdit, PicksATableByNameByMaterialOrByNumber) {
  const auto ore = edited(seed_mill(), "materials[ore].poisson_ratio", "0.25");
  EXPECT_EQ(case_from_document(ore).materials[1].poisson_ratio, 0.25);
  const auto pair = edited(seed_mill(), "pairs[ore,steel].restitution", "0.6");
  EXPECT_EQ(case_from_document(pair).pairs[1].restitution, 0.6);
  const auto few = edited(pilot(), "charge.counts[1].count", "300");
  EXPECT_EQ(case_from_document(few).charge.classes[1].count, 300);
}

TEST(CaseEdit, RefusesAKeyThatNoCaseHas) {
  EXPECT_THAT(refusal("mill.rowz", pilot()), HasSubstr("did you mean `mill.rows`?"));
}

TEST(CaseEdit, RefusesATableThatIsNotTheOnlyOneOrNotThere) {
  EXPECT_THAT(refusal("pairs.restitution", pilot()), HasSubstr("name one in brackets"));
  EXPECT_THAT(refusal("mill[0].rows", pilot()), HasSubstr("write `mill.rows`"));
  EXPECT_THAT(refusal("materials[gold].poisson_ratio", pilot()), HasSubstr("there are: steel"));
  EXPECT_THAT(refusal("charge.counts[steel].count", pilot()), HasSubstr("more than one"));
}

TEST(CaseEdit, ReadsValuesAsACommandLineHasThem) {
  const auto is = [](const char* text, auto wanted) {
    return std::get<decltype(wanted)>(value_from_text(text, 1).data) == wanted;
  };
  EXPECT_TRUE(is("12", std::int64_t{12}));
  EXPECT_TRUE(is("1e-3", 1e-3));
  EXPECT_TRUE(is("true", true));
  EXPECT_TRUE(is("adaptive", std::string("adaptive")));
  EXPECT_TRUE(is("3mm", std::string("3mm")));
}

}  // namespace
}  // namespace millwear
