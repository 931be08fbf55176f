#include <gmock/gmock.h>

#include <cmath>

#include "mill/base/failure.h"
#include "mill/base/whole_file.h"
#include "orchestrator/campaign/kept_cycle.h"
#include "orchestrator/dem_run/measured.h"
#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const LinerSector sector{0.52, 0.5, 12};

class KeptFile : public testing::Test {
 protected:
  [[nodiscard]] std::string refusal_of_measured() const {
    return failure_of<ResultRejected>([&] { static_cast<void>(read_measured(file)); });
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "kept.json";
};

// 0.1 and 1/3 have no short decimal form: they come back bit by bit.
TEST_F(KeptFile, OfAMeasurementComesBackAsItWas) {
  Measured measured{};
  measured.power = 0.1;
  measured.power_error = 1.0 / 3.0;
  measured.power_times = {0.25, 0.5};
  measured.power_series = {1e-300, -2.0 / 3.0};
  measured.charge.toe = 3.5;
  measured.charge.toe_error = std::nan("");
  measured.charge.shoulder = 0.7;
  measured.charge.shoulder_error = 0.01;
  measured.samples = 1234567890123;
  measured.rejected_share = 1e-4;
  measured.revolutions = 1.0 / 3.0;
  measured.peak_error = 0.046;
  measured.target_error = 0.05;
  measured.motion.airborne_share = {0.1, 0.01};
  measured.motion.dead_zone_share = {0.2, 0.02};
  measured.motion.between_locked_share = {0.3, 0.03};
  measured.motion.packed_share = {0.4, 0.04};
  measured.motion.bare_hit_mass_share = {0.5, 0.05};
  measured.motion.bare_hit_power = {0.6, 0.06};
  measured.motion.bare_hit_falling_power = {0.7, 0.07};
  write_measured(file, measured);
  const Measured read = read_measured(file);
  EXPECT_EQ(read.power, measured.power);
  EXPECT_EQ(read.power_error, measured.power_error);
  EXPECT_EQ(read.power_times, measured.power_times);
  EXPECT_EQ(read.power_series, measured.power_series);
  EXPECT_EQ(read.charge.toe, 3.5);
  EXPECT_TRUE(std::isnan(read.charge.toe_error));
  EXPECT_EQ(read.charge.shoulder, 0.7);
  EXPECT_EQ(read.charge.shoulder_error, 0.01);
  EXPECT_EQ(read.samples, 1234567890123);
  EXPECT_EQ(read.rejected_share, 1e-4);
  EXPECT_EQ(read.revolutions, 1.0 / 3.0);
  EXPECT_EQ(read.peak_error, 0.046);
  EXPECT_EQ(read.target_error, 0.05);
  EXPECT_EQ(read.motion.airborne_share.value, 0.1);
  EXPECT_EQ(read.motion.airborne_share.error, 0.01);
  EXPECT_EQ(read.motion.dead_zone_share.value, 0.2);
  EXPECT_EQ(read.motion.between_locked_share.value, 0.3);
  EXPECT_EQ(read.motion.packed_share.value, 0.4);
  EXPECT_EQ(read.motion.bare_hit_mass_share.value, 0.5);
  EXPECT_EQ(read.motion.bare_hit_power.value, 0.6);
  EXPECT_EQ(read.motion.bare_hit_falling_power.error, 0.07);
  EXPECT_TRUE(std::isnan(read.motion.bare_hit_plate_power.value));
  measured.peak_error = std::nan("");
  measured.target_error.reset();
  write_measured(file, measured);
  EXPECT_TRUE(std::isnan(read_measured(file).peak_error));
  EXPECT_FALSE(read_measured(file).target_error);
}

TEST(Measured, TellsWhyItEnded) {
  Measured measured{};
  measured.revolutions = 1.5;
  measured.peak_error = 0.0461;
  EXPECT_EQ(end_of(measured), MeasurementEnd::no_target);
  EXPECT_EQ(spoken_end(measured), "measured for 1.5 revolutions, rate at its peaks known to 4.6 %");
  measured.target_error = 0.05;
  EXPECT_EQ(end_of(measured), MeasurementEnd::target_reached);
  EXPECT_EQ(spoken_end(measured),
            "measured for 1.5 revolutions, rate at its peaks known to 4.6 % (target 5 %)");
  measured.peak_error = 0.071;
  measured.revolutions = 3.0;
  EXPECT_EQ(end_of(measured), MeasurementEnd::most_revolutions);
  EXPECT_EQ(
      spoken_end(measured),
      "measured for 3 revolutions, rate at its peaks known to 7.1 % after the greatest number "
      "of revolutions; 5 % would take about 6");
  measured.peak_error = std::nan("");
  EXPECT_EQ(end_of(measured), MeasurementEnd::most_revolutions);
  measured.target_error.reset();
  measured.revolutions = 1.0;
  EXPECT_EQ(spoken_end(measured), "measured for 1 revolution, rate at its peaks not known");
}

TEST_F(KeptFile, OfACycleComesBackAsItWas) {
  KeptStep step{};
  step.duration = 3600.0 / 7.0;
  step.removed_area = 1e-4 / 3.0;
  step.accounted_area = 1e-4 / 3.0 + 1e-12;
  step.profile = {sector, {{-0.1, 0.0}, {0.0, 1.0 / 30.0}, {0.1, 0.0}}};
  write_cycle(file, {0.05, 2e-9, {step, step}});
  const KeptCycle read = read_cycle(file, sector);
  EXPECT_EQ(read.smoothing_moved_share, 0.05);
  EXPECT_EQ(read.worn_by_load, 2e-9);
  ASSERT_EQ(read.steps.size(), 2u);
  EXPECT_EQ(read.steps[1].duration, step.duration);
  EXPECT_EQ(read.steps[1].removed_area, step.removed_area);
  EXPECT_EQ(read.steps[1].accounted_area, step.accounted_area);
  EXPECT_EQ(read.steps[1].profile.nodes, step.profile.nodes);
  EXPECT_EQ(read.steps[1].profile.sector.rows, 12);
}

TEST_F(KeptFile, CutShortIsRefusedByName) {
  write_measured(file, {});
  const std::string whole = text_of(file);
  for (const std::size_t length : {std::size_t{0}, whole.size() / 2, whole.size() - 3}) {
    put_text(file, whole.substr(0, length));
    EXPECT_THAT(refusal_of_measured(), HasSubstr(file.string())) << length;
  }
}

TEST_F(KeptFile, OfAnotherKindOrVersionIsRefusedByName) {
  write_cycle(file, {});
  EXPECT_THAT(refusal_of_measured(), AllOf(HasSubstr(file.string()), HasSubstr("not a millwear")));
  put_text(file, R"({"type": "millwear measured", "format_version": 2})");
  EXPECT_THAT(refusal_of_measured(), HasSubstr("version 3"));
}

TEST_F(KeptFile, ThatIsMissingOrCannotBeWrittenIsADiskError) {
  EXPECT_THROW(static_cast<void>(read_measured(file)), DiskError);
  EXPECT_THROW(write_measured(folder.path() / "none" / "kept.json", {}), DiskError);
  EXPECT_THROW(write_file("/dev/full", "x"), DiskError);
}

}  // namespace
}  // namespace millwear::orchestrator
