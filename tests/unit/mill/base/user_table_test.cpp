#include "mill/base/user_table.h"

#include <gmock/gmock.h>

#include "mill/base/failure.h"

namespace millwear {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(UserTable, FindsANeededColumnByItsName) {
  const UserTable table = user_table("# a comment\nx_m, y_m\n1,2\n", "contacts.csv");
  EXPECT_EQ(needed_column(table, "y_m"), 1);
}

TEST(UserTable, NamesTheLineAndTheColumnsWhereANeededOneIsMissing) {
  const UserTable table = user_table("# a comment\nx_m, y_m\n1,2\n", "contacts.csv");
  EXPECT_THAT([&] { static_cast<void>(needed_column(table, "z_m")); },
              ThrowsMessage<InputError>(
                  HasSubstr("contacts.csv:2: no column `z_m` among x_m, y_m; add it")));
}

TEST(UserTable, SaysThatItIsEmptyWhereAColumnIsNeeded) {
  const UserTable table = user_table("\n", "contacts.csv");
  EXPECT_THAT([&] { static_cast<void>(needed_column(table, "x_m")); },
              ThrowsMessage<InputError>(HasSubstr("contacts.csv:1: the table is empty")));
}

}  // namespace
}  // namespace millwear
