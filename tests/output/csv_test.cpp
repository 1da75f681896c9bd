#include "output/folder/csv.hpp"

#include <gtest/gtest.h>

using namespace reye::output;

// A cell that a spreadsheet would run as a formula must not begin as one; numbers stay numbers.
TEST(Csv, NoFormulas) {
  for (const char* formula :
       {"=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", " =1", "\r=1", "-a", "=", "''=1"}) {
    const std::string field = csv_field(formula);
    const auto first = field.find_first_not_of("\" ");
    EXPECT_EQ(field[first], '\'') << field;
  }
  for (const char* plain : {"-80", "+5", "-1.5e-7", "0.3", "press", "a=b", "a - b", "O'Neill", "-inf"})
    EXPECT_EQ(csv_field(plain), plain);
}

// Every text must come back as it went in, but for control characters, and leave its neighbours alone.
TEST(Csv, ReadsBack) {
  for (const char* text :
       {"", "a", "a,b", "a\"b", "\"", "a;b", "=1", "'=1", "''=1", "'", "'a", "-", "- 5", "+,\"", "µ"}) {
    const auto cells = csv_cells("x," + csv_field(text) + ",y");
    ASSERT_EQ(cells.size(), 3u) << text;
    EXPECT_EQ(cells[1], text);
    EXPECT_EQ(cells[2], "y");
  }
  EXPECT_EQ(csv_cells(csv_field("two\nlines"))[0], "two lines");
}

// A cell is a number as a whole or not at all.
TEST(Csv, Numbers) {
  EXPECT_EQ(csv_number("-1e-320"), -1e-320);
  EXPECT_THROW(csv_number("1.5mm"), std::runtime_error);
  EXPECT_THROW(csv_number(""), std::runtime_error);
}
