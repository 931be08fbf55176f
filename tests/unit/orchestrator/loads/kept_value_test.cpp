#include "orchestrator/loads/kept_value.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/temporary_folder.h"

namespace millwear::orchestrator {
namespace {

class KeptValue : public testing::Test {
 protected:
  TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "kept" / "load";
};

TEST_F(KeptValue, ComesBackUnderItsKey) {
  const Eigen::MatrixXd matrix{{1.0, 0.1, -0.0}, {1e-300, 3.0, 1e300}};
  keep_value(file, "key", matrix);
  EXPECT_EQ(kept_value<Eigen::MatrixXd>(file, "key"), matrix);
  EXPECT_FALSE(kept_value<Eigen::MatrixXd>(file, "another").has_value());
}

TEST_F(KeptValue, IsNoneOfAnotherKind) {
  keep_value(file, "key", std::vector<double>{1.0, 2.0});
  EXPECT_FALSE(kept_value<std::vector<int>>(file, "key").has_value()) << "goes on";
  EXPECT_FALSE(kept_value<std::vector<std::string>>(file, "key").has_value()) << "a long length";
  keep_value(file, "key", std::vector<int>{1, 2});
  EXPECT_FALSE(kept_value<std::vector<double>>(file, "key").has_value()) << "ends early";
  keep_value(file, "key", std::vector<double>{1e300, 1e300, 1e300});
  EXPECT_FALSE(kept_value<Eigen::MatrixXd>(file, "key").has_value()) << "rows that do not divide";
}

}  // namespace
}  // namespace millwear::orchestrator
