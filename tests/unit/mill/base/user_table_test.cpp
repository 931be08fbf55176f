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

struct Written {
  std::string_view name;
  std::string_view text;
};

class TableAsItComes : public testing::TestWithParam<Written> {};

// Every one of them says x = -0.5, 1.5 and y = 2000, 0.25.
TEST_P(TableAsItComes, IsRead) {
  const UserTable table = user_table(GetParam().text, "scan.csv");
  const std::size_t x = needed_column(table, "x");
  const std::size_t y = needed_column(table, "y");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(number_in(table, table.rows[0], x, ""), -0.5);
  EXPECT_EQ(number_in(table, table.rows[1], x, ""), 1.5);
  EXPECT_EQ(number_in(table, table.rows[0], y, ""), 2000.0);
  EXPECT_EQ(number_in(table, table.rows[1], y, ""), 0.25);
}

INSTANTIATE_TEST_SUITE_P(
    Written, TableAsItComes,
    testing::Values(Written{"comma", "x,y\n-0.5,2000\n1.5,0.25\n"},
                    Written{"semicolon", "x;y\n-0.5;2000\n1.5;0.25\n"},
                    Written{"tab", "x\ty\n-0.5\t2000\n1.5\t0.25\n"},
                    Written{"blanks", "  x   y\n -0.5  2000\n  1.5  0.25 \n"},
                    Written{"decimal_comma", "x;y\n-0,5;2000\n1,5;0,25\n"},
                    Written{"quoted_decimal_comma", "x,y\n\"-0,5\",2000\n\"1,5\",\"0,25\"\n"},
                    Written{"quotes", "\"x\",\"y\"\n\"-0.5\",\"2000\"\n\"1.5\",\"0.25\"\n"},
                    Written{"cr", "x,y\r-0.5,2000\r1.5,0.25"},
                    Written{"crlf", "x,y\r\n-0.5,2000\r\n1.5,0.25\r\n"},
                    Written{"plus", "x,y\n-0.5,+2e3\n+1.5,+0.25\n"},
                    Written{"upper_case", "Y,X\n2E3,-0.5\n0.25,1.5\n"},
                    Written{"trailing", "x;y;\n-0.5;2000;\n1.5;0.25;;\n"},
                    Written{"comments",
                            "% a gauge\n// of 1998\nx,y # m\n\n-0.5,2000\n#\n1.5,0.25"}),
    [](const auto& written) { return std::string(written.param.name); });

std::string refusal(std::string_view text) {
  try {
    const UserTable table = user_table(text, "scan.csv");
    for (const UserRow& row : table.rows)
      for (std::size_t i = 0; i < row.fields.size(); ++i)
        static_cast<void>(number_in(table, row, i, "a length"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(UserTable, RefusesWhatMayMeanTwoThings) {
  EXPECT_THAT(refusal("x;y\n0,5;1\n1;0.5\n"),
              HasSubstr("scan.csv:3: `0.5` has a decimal point and line 2 has a decimal comma"));
  EXPECT_THAT(refusal("x;y\n1.234,5;1\n"), HasSubstr("scan.csv:2: `1.234,5` is not a number"));
  EXPECT_THAT(refusal("x,y\n-0,5,1,5\n"), HasSubstr("decimal comma need `;` or tabs"));
  EXPECT_THAT(refusal("x,y\n\"1,2\n"), HasSubstr("scan.csv:2: a quote (\") does not end"));
  EXPECT_THAT(refusal("x,y\n+-1,2\n"), HasSubstr("`+-1` is not a number"));
}

}  // namespace
}  // namespace millwear
