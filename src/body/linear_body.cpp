#include <cassert>
#include <utility>

#include "body/columns.hpp"
#include "body/operator.hpp"
#include "fem/assemble_loads.hpp"
#include "fem/stiffness.hpp"

namespace reye::body {

using base::SparseMatrix;

namespace {

/// One load of the scene, on the unknowns y and condensed to q (both for history factor 1).
struct CondensedLoad {
  Vector full;
  Vector condensed;
};

}  // namespace

struct LinearBody::Impl {
  ShapePtr shape;
  Columns columns;  ///< without terms
  SparseMatrix B;
  algebra::SchurFactor factor;
  Translation translation;
  std::vector<LoadColumn> names;
  std::vector<CondensedLoad> loads;

  Impl(ShapePtr s, const BodyInput& input, algebra::SchurAnalysisPtr known)
      : shape(std::move(s)),
        columns(number_columns(shape->mesh, input)),
        B(expansion()),
        factor(reduced_stiffness(input), columns.retained, std::move(known)),
        translation(columns.translations(input.analysis).bottomRows(columns.retained)) {
    for_each_load(input, [&](const auto& load) {
      Vector full = B.transpose() * fem::load_vector(shape->mesh, input.analysis, load);
      Vector condensed = factor.condense(full);
      names.push_back({load.name, load.history});
      loads.push_back({std::move(full), std::move(condensed)});
    });
  }

  /// B, and the terms that it was made of let go.
  SparseMatrix expansion() {
    SparseMatrix expansion = columns.expansion();
    columns.terms = {};
    return expansion;
  }

  /// B^T K B
  SparseMatrix reduced_stiffness(const BodyInput& input) const {
    SparseMatrix K = fem::stiffness(shape->mesh, input.material, input.analysis, input.b_bar);
    const SparseMatrix KB = K * B;
    SparseMatrix().swap(K);  // its memory is needed for the product
    return B.transpose() * KB;
  }
};

LinearBody::LinearBody(ShapePtr shape, const BodyInput& input, algebra::SchurAnalysisPtr known)
    : impl_(std::make_shared<const Impl>(std::move(shape), input, std::move(known))) {}

const algebra::SchurAnalysisPtr& LinearBody::analysis() const { return impl_->factor.analysis(); }
int LinearBody::dofs() const { return impl_->columns.retained; }
int LinearBody::full_dofs() const { return impl_->columns.interior + impl_->columns.retained; }
const std::vector<int>& LinearBody::contact_nodes() const { return impl_->columns.contact_nodes; }
const Matrix& LinearBody::tangent(const Vector&, const Vector&) const { return impl_->factor.schur(); }
const Translation& LinearBody::translation() const { return impl_->translation; }
const std::vector<SupportColumn>& LinearBody::support_columns() const { return impl_->columns.supports; }
const std::vector<LoadColumn>& LinearBody::loads() const { return impl_->names; }
const std::vector<CurvedEdge>& LinearBody::curved_edges() const { return impl_->columns.curved_edges; }

NodePosition LinearBody::position(int contact_node, const Vector& q) const {
  const ContactNode& node = impl_->columns.seen[contact_node];
  NodePosition p;
  p.x = node.X;
  for (Term term : node.terms) {
    term.column -= impl_->columns.interior;  // from the unknowns y to q: all columns of a contact node are retained
    p.x += q[term.column] * term.direction;
    p.terms[p.count++] = term;
  }
  return p;
}

NodeFreedom LinearBody::freedom(int contact_node) const {
  return impl_->columns.seen[contact_node].freedom;
}

Vector LinearBody::residual(const Vector& q, const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  Vector r = impl_->factor.schur() * q;
  for (size_t i = 0; i < impl_->loads.size(); ++i) r -= load_factors[i] * impl_->loads[i].condensed;
  return r;
}

Vector LinearBody::at_supports(const Vector& q, const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  Vector r = Vector::Zero(dofs());
  for (const SupportColumn& support : support_columns()) {
    const int k = support.column;
    r[k] = impl_->factor.schur().col(k).dot(q);
    for (size_t i = 0; i < impl_->loads.size(); ++i) r[k] -= load_factors[i] * impl_->loads[i].condensed[k];
  }
  return r;
}

std::vector<Vec2> LinearBody::recover(const Vector& q, const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  Vector f = Vector::Zero(full_dofs());
  for (size_t i = 0; i < impl_->loads.size(); ++i) f += load_factors[i] * impl_->loads[i].full;
  const Vector u = impl_->B * impl_->factor.recover(f, q);
  std::vector<Vec2> nodal(impl_->shape->mesh.X.size());
  for (size_t node = 0; node < nodal.size(); ++node) nodal[node] = u.segment<2>(2 * node);
  return nodal;
}

}  // namespace reye::body
