#include <algorithm>

#include "contact/interface.hpp"

/// Nodes that carry no multiplier in an iteration: slivers, and those that are left to another contact.
namespace reye::contact {

double Interface::covered(int facet) const {
  const int r = record_of_[setup_->secondary.facets[facet][0]][1];
  if (r < 0 || (*records_)[r].facet != facet) return 0.0;
  const auto& on_X = (*records_)[r].value.on_X;
  return on_X[0] + on_X[1] + on_X[2];
}

void Interface::leave(const std::vector<int>& nodes, const std::vector<int>& facets) {
  std::erase_if(*records_, [&](const mortar::FacetRecord& r) {
    return std::find(facets.begin(), facets.end(), r.facet) != facets.end();
  });
  for (int node : nodes) placement_.cut[node] = left_[node] = 1;
  for (auto& record : *records_)
    for (int node : setup_->secondary.facets[record.facet])
      if (node >= 0 && left_[node]) {
        integrator_.renew(placement_, record);
        break;
      }
  sum_rows();
  if (leave_out_slivers()) sum_rows();
  sum_start_of_increment();
}

/// Cuts nodes whose covered length is nearly zero: such a node carries no multiplier; its share goes to the other node
/// of the facet, or forces would be lost there: the dual functions of the others alone do not add up to one.
bool Interface::leave_out_slivers() {
  bool found = false;
  for (std::size_t j = 0; j < at_.rows.size(); ++j) {
    const int node = static_cast<int>(j);
    if (placement_.cut[j] || !meets(node) || touching(node)) continue;
    placement_.cut[j] = found = true;
    for (int r : record_of_[node])
      if (r >= 0) integrator_.renew(placement_, (*records_)[r]);
  }
  return found;
}

}  // namespace reye::contact
