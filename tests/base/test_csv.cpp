#include <gtest/gtest.h>

#include "base/csv.hpp"
#include "base/errors.hpp"

using namespace reye;

namespace {

std::string refusal_of(const std::string& csv, const std::string& header = {}) {
  try {
    base::parse_numbers(csv, header);
  } catch (const base::InputError& error) {
    return error.issues().front().rule;
  }
  return {};
}

}  // namespace

// A table must be read with names, numbers and the lines they stand in, whatever blanks, line ends and signs there are.
TEST(Csv, NamesAndRows) {
  const auto table = base::parse_numbers("\xEF\xBB\xBFtime_s, force_N\r\n0,+1.5\r\n\r\n 2e-1 , -3\r\n");
  EXPECT_EQ(table.names, (std::vector<std::string>{"time_s", "force_N"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].values, (std::vector{0.0, 1.5}));
  EXPECT_EQ(table.rows[1].values, (std::vector{0.2, -3.0}));
  EXPECT_EQ(table.rows[1].line, 4);
  EXPECT_EQ(table.column("force_N"), 1);
  EXPECT_EQ(table.column("other"), -1);
}

// What is no such table must be refused with its line.
TEST(Csv, Refusals) {
  EXPECT_EQ(refusal_of("a,b\n1,2\n3\n"), "line 3: must be two numbers with a comma between them");
  EXPECT_EQ(refusal_of("a,b,c\n1,2\n"), "line 2: must be 3 numbers with commas between them");
  EXPECT_EQ(refusal_of("a\nx\n"), "line 2: must be a number");
  EXPECT_EQ(refusal_of("a,b\n1,nan\n"), "line 2: must be finite");
  EXPECT_EQ(refusal_of("a;b\n1,5;2\n"),
            "line 1: its columns are separated by ';'; write commas between columns, and decimal points");
  EXPECT_EQ(refusal_of("a,b\n", "level,cycles"), "its first line must be level,cycles");
}
