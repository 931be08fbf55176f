#include "orchestrator/validation/validation_table.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::HasSubstr;

class PublishedFigures : public testing::Test {
 protected:
  [[nodiscard]] std::vector<PublishedFigure> read(const std::string& lines) const {
    write_file(file, "quantity,value,error,mill_length_m,lifter_height_m,source\n" + lines);
    return read_published_figures(file);
  }
  [[nodiscard]] std::string refusal(const std::string& lines) const {
    try {
      static_cast<void>(read(lines));
    } catch (const InputError& error) {
      return error.what();
    }
    return "not refused";
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "published.csv";
};

TEST_F(PublishedFigures, HaveAnErrorALengthAndASource) {
  const auto figures =
      read("power_w,70,2,0.305,,Steiner 1996\ntoe_deg,230,,,,Morrell 1992  # table 4\n");
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].quantity, Quantity::power);
  EXPECT_EQ(figures[0].figure.value, 70.0);
  EXPECT_EQ(figures[0].figure.error, 2.0);
  EXPECT_EQ(figures[0].mill_length, 0.305);
  EXPECT_EQ(figures[1].source, "Morrell 1992");
  EXPECT_TRUE(std::isnan(figures[1].figure.error));
}

TEST_F(PublishedFigures, WithoutASourceAreRefusedWithTheirLine) {
  EXPECT_THAT(refusal("toe_deg,230,,,,\n"),
              HasSubstr("published.csv:2: a figure without a source"));
}

TEST_F(PublishedFigures, OfNoQuantityLengthOrHeightAreRefused) {
  EXPECT_THAT(refusal("tow_deg,230,,,,x\n"), HasSubstr("`tow_deg` is no quantity"));
  EXPECT_THAT(refusal("power_w,70,,,,x\n"), HasSubstr("a power without `mill_length_m`"));
  EXPECT_THAT(refusal("face_angle_deg,47,,,,x\n"),
              HasSubstr("a face angle without `lifter_height_m`"));
  EXPECT_THAT(refusal("power_w,seventy,,1,,x\n"), HasSubstr("`seventy` is not a number"));
}

TEST(SimulatedFigures, ReadBackAsTheyAreKept) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "simulated.csv";
  write_file(file, simulated_csv({{Quantity::power, {72.8, 0.3}}, {Quantity::face_angle, {26.5}}}));
  const auto figures = read_simulated_csv(file);
  EXPECT_EQ(figures.at(Quantity::power).value, 72.8);
  EXPECT_EQ(figures.at(Quantity::power).error, 0.3);
  EXPECT_EQ(figures.at(Quantity::face_angle).value, 26.5);
  EXPECT_TRUE(std::isnan(figures.at(Quantity::face_angle).error));
}

// Two standard errors of 70 +- 2 and 73 +- 0.3 are 4.04.
TEST(ValidationVerdict, WeighsTheErrorsOfBoth) {
  const PublishedFigure power{Quantity::power, {70.0, 2.0}, 0.305, {}, "x"};
  EXPECT_EQ(verdict_of(power, {74.0, 0.3}), "agrees (+5.7 %)");
  EXPECT_EQ(verdict_of(power, {74.1, 0.3}), "off (+5.9 %)");
  const PublishedFigure toe{Quantity::toe, {230.0}, {}, {}, "x"};
  EXPECT_EQ(verdict_of(toe, {226.0, 1.0}), "off (-4.0°)");
  EXPECT_EQ(verdict_of(toe, {}), "not found");
}

TEST(ValidationTable, HasARowForEveryPublishedFigure) {
  const Validation bond{"bond_mill",
                        {{Quantity::power, {70.0, 2.0}, 0.305, {}, "Steiner 1996"}},
                        {{Quantity::power, {72.8, 0.3}}}};
  EXPECT_THAT(validation_table({bond}),
              HasSubstr("| bond_mill | net power, W | 70 ± 2 | 72.8 ± 0.3 | agrees (+4.0 %) | "
                        "Steiner 1996 |\n"));
}

TEST(ValidationTable, TellsThePowerOfAPlantInMegawatts) {
  const Validation plant{"sag_mill",
                         {{Quantity::power, {10.96e6, 0.55e6}, 5.03, {}, "Doll 2016"}},
                         {{Quantity::power, {7.86e6, 0.03e6}}}};
  EXPECT_THAT(validation_table({plant}),
              HasSubstr("| net power, MW | 10.96 ± 0.55 | 7.86 ± 0.03 | off (-28.3 %) |"));
}

}  // namespace
}  // namespace millwear::orchestrator
