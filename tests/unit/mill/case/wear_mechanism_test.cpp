#include "mill/case/wear_mechanism.h"

#include <gtest/gtest.h>

#include "mill/case/case_units.h"
#include "tests/support/example_case.h"

namespace millwear {
namespace {

// Steel of 50 mm, ore of 30 and 20 mm.
std::string concerned(const WearMechanism& mechanism) {
  std::string pattern;
  for (const auto& kind : example_case().charge.classes)
    pattern += concerns(mechanism, kind) ? "1" : "0";
  return pattern;
}

TEST(WearMechanism, ConcernsItsMaterialAndSizesBothIncluded) {
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12}), "111");
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12, 0.0, std::size_t{1}}), "011");
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12, 0.0, {}, 0.03}), "110");
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12, 0.0, {}, {}, 0.03}), "011");
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12, 0.0, {}, 0.021, 0.03}), "010");
  EXPECT_EQ(concerned({WearLaw::archard, 1e-12, 0.0, std::size_t{0}, {}, 0.03}), "000");
  EXPECT_EQ(concerned({WearLaw::corrosion, 0.0, 1e-11}), "000");
}

TEST(WearMechanism, IsSpokenOfInWords) {
  const auto materials = example_case().materials;
  EXPECT_EQ(spoken(WearMechanism{WearLaw::archard, 1e-12}, materials), "Archard, k = 1e-12 1/Pa");
  EXPECT_EQ(spoken({{WearLaw::finnie, 2e-13, 0.0, std::size_t{1}, 0.02, 0.05},
                    {WearLaw::shear_dissipation, 1e-12, 0.0, {}, 0.05},
                    {WearLaw::corrosion, 0.0, depth_rate_from_m_per_year(1e-4)}},
                   materials),
            "Finnie, k = 2e-13 1/Pa, ore of 20 to 50 mm + shear dissipation, k = 1e-12 1/Pa, "
            "particles of 50 mm and more + corrosion, 0.1 mm a year");
}

TEST(WearMechanism, LawsComeBackFromTheirNames) {
  for (const auto name : wear_law_names) EXPECT_EQ(name_of(wear_law_from(name)), name);
}

}  // namespace
}  // namespace millwear
