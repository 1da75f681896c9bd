#include "body/operator.hpp"

namespace reye::body {

BodyInput::BodyInput() = default;
BodyInput::BodyInput(const BodyInput&) = default;
BodyInput::BodyInput(BodyInput&&) noexcept = default;
BodyInput& BodyInput::operator=(const BodyInput&) = default;
BodyInput& BodyInput::operator=(BodyInput&&) noexcept = default;
BodyInput::~BodyInput() = default;

}  // namespace reye::body
