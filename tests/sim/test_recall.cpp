#include <gtest/gtest.h>

#include "sim/problem/recall.hpp"

using namespace reye;
using contact::ContactStatus;

namespace {

solver::SolverState touching(const std::vector<ContactStatus>& status) {
  solver::SolverState state;
  state.q = base::Vector::Zero(1);
  contact::ContactState contact;
  contact.status = status;
  contact.lambda.assign(status.size(), base::Vec2::Zero());
  state.contacts.push_back(std::move(contact));
  return state;
}

// What touched in a recalled cycle must be every node that was active in any of its increments, and nothing where the
// cycle is of another step or none was played.
TEST(Recall, KnowsWhatTouchedInACycle) {
  const auto open = ContactStatus::inactive, slip = ContactStatus::slip, stick = ContactStatus::stick;
  sim::Recall recall;
  EXPECT_TRUE(sim::touched(recall, 2).empty());
  const auto start = touching({open, open, open, open});
  sim::note(recall, 2, 0.0, 0.5, start, touching({stick, slip, open, open}));
  sim::note(recall, 2, 0.5, 1.0, start, touching({open, slip, slip, open}));
  EXPECT_EQ(sim::touched(recall, 2), (std::vector<std::vector<char>>{{1, 1, 1, 0}}));
  EXPECT_TRUE(sim::touched(recall, 3).empty());
}

}  // namespace
