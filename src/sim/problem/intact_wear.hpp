#pragma once
#include "contact/fields.hpp"
#include "sim/problem/block_wear.hpp"
#include "sim/problem/finite.hpp"

namespace reye::sim {

/// Checks that what the last block has worn is of these contacts: of their points, and numbers.
template <class Contact>
void check_last_wear(const BlockWear<Contact>& last, const std::vector<Contact>& contacts) {
  const std::string what = "what its last block has worn ";
  require(finite(last.cycles) && last.cycles >= 0.0 && finite(last.course.cycles) && last.course.cycles >= 0.0,
          what + "took no number of cycles");
  for (const auto& [name, value] : last.measures) require(finite(value), what + "has a measure that is not a number");
  if (last.cycles == 0.0) return;
  require(last.contacts.size() == contacts.size(), what + "is of a contact too many or too few");
  for (std::size_t c = 0; c < contacts.size(); ++c)
    contact::for_each_field(contacts[c], last.contacts[c],
                            [&](const contact::Field& field, const auto& of, const auto& grown) {
                              using Member = std::remove_cvref_t<decltype(of)>;
                              if (field.corrected == contact::Corrected::never) return;
                              if constexpr (std::same_as<Member, double>) {
                                require(finite(grown), what + "is not a number");
                              } else if constexpr (std::same_as<Member, std::vector<double>>) {
                                require(finite(grown), what + "is not a number");
                                require(grown.size() == of.size(), what + "has a value too many or too few");
                              }
                            });
  double before = 0.0;
  for (const auto& [progress, volumes] : last.course.until) {
    require(finite(progress) && progress > before && progress <= 1.0, what + "was worn at no progress");
    require(same_sizes(volumes, removed_volumes(contacts)) && finite(volumes), what + "has no volumes on the way");
    before = progress;
  }
  require(last.course.until.empty() || last.course.cycles > 0.0, what + "took no number of cycles");
}

}  // namespace reye::sim
