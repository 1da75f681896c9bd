#include <gtest/gtest.h>

#include <set>
#include <string>

#include "contact/fields.hpp"

using namespace reye;

// Each quantity must be in the list once, under the name of its member.
TEST(Fields, NamesAreUnique) {
  std::set<std::string> names;
  contact::ContactState state;
  contact::for_each_field(state, [&](const contact::Field& field, const auto&) {
    EXPECT_TRUE(names.emplace(field.name).second) << field.name;
  });
  EXPECT_EQ(names.size(), 19U);
}

// A list of two states must visit the same member of both.
TEST(Fields, PairsAreOfOneMember) {
  contact::ContactState a, b;
  int visits = 0;
  contact::for_each_field(a, b, [&](const contact::Field&, auto& of_a, auto& of_b) {
    ++visits;
    EXPECT_EQ(reinterpret_cast<char*>(&of_a) - reinterpret_cast<char*>(&a),
              reinterpret_cast<char*>(&of_b) - reinterpret_cast<char*>(&b));
  });
  EXPECT_EQ(visits, 19);
}

// A cleared state must have a value per node of its side for every nodal quantity, and none for an optional one.
TEST(Fields, ClearedToTheNodesOfItsSide) {
  contact::ContactState state;
  contact::clear_fields(state, 5, 3, [](const contact::Field&) { return true; });
  contact::for_each_field(state, [](const contact::Field& field, const auto& member) {
    if constexpr (!std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>) {
      const std::size_t nodes = field.site == contact::Site::secondary ? 5U : 3U;
      EXPECT_EQ(member.size(), field.optional ? 0U : nodes) << field.name;
    }
  });
}
