#include "contact/state.hpp"

namespace reye::contact {

ContactState::ContactState() = default;
ContactState::ContactState(const ContactState&) = default;
ContactState::ContactState(ContactState&&) noexcept = default;
ContactState& ContactState::operator=(const ContactState&) = default;
ContactState& ContactState::operator=(ContactState&&) noexcept = default;
ContactState::~ContactState() = default;

}  // namespace reye::contact
