#include "base/cores.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

using namespace reye;

TEST(Cores, HoldWhileTheyLive) {
  // One core is used unless more are asked for, and the number before is used again afterwards.
  EXPECT_EQ(base::cores(), 1);
  {
    const base::Cores three(3);
    EXPECT_EQ(base::cores(), 3);
    {
      const base::Cores two(2);
      EXPECT_EQ(base::cores(), 2);
    }
    EXPECT_EQ(base::cores(), 3);
  }
  EXPECT_EQ(base::cores(), 1);
  EXPECT_GE(base::physical_cores(), 1);
}

TEST(Cores, EveryNumberIsWorkedOnOnce) {
  // Shares cover all numbers once, the last share being shorter, on any number of cores.
  for (const int count : {0, 1, 7, 64, 1001}) {
    for (const int number : {1, 2, 4}) {
      const base::Cores cores(number);
      std::vector<int> worked(static_cast<std::size_t>(count), 0);
      base::side_by_side(count, 10, [&](int first, int end) {
        EXPECT_LE(end - first, 10);
        for (int i = first; i < end; ++i) ++worked[static_cast<std::size_t>(i)];
      });
      EXPECT_EQ(worked, std::vector<int>(static_cast<std::size_t>(count), 1));
    }
  }
}

TEST(Cores, TheFirstExceptionIsThrownOn) {
  // Whichever call fails first in time, the exception of the lowest number leaves.
  for (const int number : {1, 2, 4}) {
    const base::Cores cores(number);
    try {
      base::side_by_side(200, [](int i) {
        if (i % 50 == 37) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "37");
    }
  }
}
