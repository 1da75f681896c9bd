#include "body/operator.hpp"

namespace reye::body {

int dofs(const Operator& op) {
  return std::visit([](const auto& o) { return o.dofs(); }, op);
}

const std::vector<int>& contact_nodes(const Operator& op) {
  return std::visit(
      [](const auto& o) -> const auto& { return o.contact_nodes(); }, op);
}

const std::vector<SupportColumn>& support_columns(const Operator& op) {
  return std::visit(
      [](const auto& o) -> const auto& { return o.support_columns(); }, op);
}

const std::vector<LoadColumn>& loads(const Operator& op) {
  return std::visit(
      [](const auto& o) -> const auto& { return o.loads(); }, op);
}

}  // namespace reye::body
