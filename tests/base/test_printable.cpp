#include <gtest/gtest.h>

#include "base/in_words.hpp"
#include "base/printable.hpp"

using namespace reye::base;

// Whatever bytes a name has, a message must keep what is printable and show the rest as escapes, in one line.
TEST(Printable, AnyBytes) {
  EXPECT_EQ(printable("stage 3, 20 µm, 軸"), "stage 3, 20 µm, 軸");
  EXPECT_EQ(printable("a\nb\tc\rd\x1b[31m\x7f"), "a\\nb\\tc\\rd\\x1b[31m\\x7f");
  EXPECT_EQ(printable("\xff\xc3("), "\\xff\\xc3(");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");           // a control character of two bytes
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a pair
  EXPECT_EQ(printable("\xc0\xaf\xf5\x80\x80\x80"), "\\xc0\\xaf\\xf5\\x80\\x80\\x80");
  EXPECT_EQ(printable(std::string("\0", 1)), "\\x00");
  EXPECT_EQ(printable("\xe8\xbb"), "\\xe8\\xbb");  // cut in the middle
}

// An error must be reported in one line, without a colon before a rule that stands alone.
TEST(Printable, IssueInWords) {
  EXPECT_EQ(in_words({"--out", "a\nb", "is a file"}), "--out = a\\nb: is a file");
  EXPECT_EQ(in_words({"", "", "is a file"}), "is a file");
}
