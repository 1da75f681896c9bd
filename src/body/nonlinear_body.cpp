#include <span>
#include <utility>

#include "base/formatted.hpp"
#include "body/condensed_tangent.hpp"
#include "body/nonlinear_equations.hpp"
#include "body/operator.hpp"
#include "material/parameters.hpp"

namespace reye::body {

namespace {

std::vector<Vec2> by_node(const Vector& u) {
  std::vector<Vec2> nodal(static_cast<size_t>(u.size() / 2));
  for (size_t node = 0; node < nodal.size(); ++node) nodal[node] = u.segment<2>(2 * node);
  return nodal;
}

}  // namespace

struct NonlinearBody::Linearised::Kept {
  std::shared_ptr<const Impl> owner;  ///< whose mesh the memory and the analysis below fit
  CondensedTangent tangent;
};

struct NonlinearBody::Impl : NonlinearEquations {
  using NonlinearEquations::NonlinearEquations;

  /// The unbalanced forces r = [r_i; r_c] where they were measured, condensed by the tangent.
  void condense(Linearised& out) const {
    const CondensedTangent& tangent = out.kept->tangent;
    out.r = tangent.condense(tangent.r);
    out.interior_residual = interior() > 0 ? tangent.r.head(interior()).cwiseAbs().maxCoeff() : 0.0;
    out.force_scale = tangent.f.largest;
    out.deformation = tangent.displacement().size() > 0 ? tangent.displacement().cwiseAbs().maxCoeff() : 0.0;
  }

  /// r_c of the unknowns v, of all cells or of those with `wanted`.
  Vector retained_residual(const Interior& before, const Vector& v, const Vector& load_factors,
                           std::span<const char> wanted) const {
    const Vector u = displacement(v);
    fem::InternalForce f;
    named([&] { fem::internal_force(mesh(), solid, u, {before.history, before.F0}, f, nullptr, wanted); });
    const Vector r = expansion(v).transpose() * unbalanced(f, u, load_factors);
    return r.tail(columns.retained);
  }
};

NonlinearBody::NonlinearBody(ShapePtr shape, const BodyInput& input)
    : impl_(std::make_shared<const Impl>(std::move(shape), input)) {}

NonlinearBody::NonlinearBody(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

NonlinearBody NonlinearBody::unyielding() const {
  if (!material::has_history(impl_->solid.material)) return *this;
  auto impl = std::make_shared<Impl>(*impl_);
  impl->solid.material = material::unyielding(impl->solid.material);
  return NonlinearBody(std::move(impl));
}

int NonlinearBody::dofs() const { return impl_->columns.retained; }
int NonlinearBody::full_dofs() const { return impl_->columns.interior + impl_->columns.retained; }
const std::vector<int>& NonlinearBody::contact_nodes() const { return impl_->columns.contact_nodes; }
const std::vector<SupportColumn>& NonlinearBody::support_columns() const { return impl_->columns.supports; }
const std::vector<LoadColumn>& NonlinearBody::loads() const { return impl_->names; }

const Translation& NonlinearBody::translation() const { return impl_->outer; }

bool NonlinearBody::symmetric() const { return impl_->symmetric(); }

NodeFreedom NonlinearBody::freedom(ContactIndex at) const { return impl_->columns.node(at).freedom; }

NodePosition NonlinearBody::position(ContactIndex at, const Vector& q) const {
  const ContactNode& node = impl_->columns.node(at);
  NodePosition p;
  p.x = node.X;
  for (const Term& term : node.terms) {
    const int column = term.column - impl_->interior();  // all columns of a contact node are retained
    const Path path = impl_->columns.path(term, q[column], impl_->turns());
    p.x += path.displacement;
    p.terms[p.count++] = {column, path.slope};
  }
  return p;
}

Interior NonlinearBody::start() const {
  return {TwoPart(Vector::Zero(impl_->interior())), fem::virgin(impl_->mesh(), impl_->solid), {}};
}

void NonlinearBody::linearise(const Interior& before, const TwoPart& y, const TwoPart& q, const Vector& load_factors,
                              Linearised& out, Tangent tangent) const {
  if (!out.kept || out.kept->owner != impl_)
    out.kept = std::make_shared<Linearised::Kept>(Linearised::Kept{impl_, CondensedTangent(*impl_)});
  out.kept->tangent.measure(*impl_, before, impl_->deformation(y, q), load_factors);
  linearise_again(before, out, tangent);
}

void NonlinearBody::linearise_again(const Interior& before, Linearised& at, Tangent tangent) const {
  at.kept->tangent.make(*impl_, before, tangent);
  at.S = at.kept->tangent.schur();
  impl_->condense(at);
}

void NonlinearBody::measure(const Interior& before, const TwoPart& y, const TwoPart& q, const Vector& load_factors,
                            Linearised& at) const {
  at.kept->tangent.measure(*impl_, before, impl_->deformation(y, q), load_factors);
  impl_->condense(at);
}

double NonlinearBody::left_out(const Linearised& at) const { return at.kept->tangent.left_out(*impl_); }

void NonlinearBody::forget(Linearised& at) {
  if (at.kept) at.kept->tangent.forget();
}

Vector NonlinearBody::interior_step(const Linearised& at, const Vector& dq) const {
  return at.kept->tangent.recover(-at.kept->tangent.r, dq).head(impl_->interior());
}

std::string NonlinearBody::least_balanced(const Linearised& at) const {
  Eigen::Index column = -1;
  if (impl_->interior() > 0) at.kept->tangent.r.head(impl_->interior()).cwiseAbs().maxCoeff(&column);
  for (int node = 0; node < impl_->mesh().node_count(); ++node)
    for (const Term& term : impl_->columns.terms[node]) {
      if (term.column != column) continue;
      const Vec2& X = impl_->mesh().X[node];
      const std::string place = base::formatted("node %d at (%.4g, %.4g) mm inside body ", node, X.x(), X.y());
      return place + impl_->name;
    }
  return "body " + impl_->name;
}

Vector NonlinearBody::retained_residual(const Interior& before, const TwoPart& y, const TwoPart& q,
                                        const Vector& load_factors) const {
  return impl_->retained_residual(before, impl_->deformation(y, q), load_factors, {});
}

Vector NonlinearBody::at_supports(const Interior& before, const TwoPart& y, const TwoPart& q,
                                  const Vector& load_factors) const {
  const Vector r = impl_->retained_residual(before, impl_->deformation(y, q), load_factors, impl_->supported);
  Vector carried = Vector::Zero(dofs());
  for (const SupportColumn& support : support_columns()) carried[support.column] = r[support.column];
  return carried;
}

Interior NonlinearBody::accepted(const Interior& before, const TwoPart& y, const TwoPart& q) const {
  const Vector u = impl_->displacement(impl_->deformation(y, q));
  const auto history = [&] { return fem::updated(impl_->mesh(), impl_->solid, u, {before.history, before.F0}); };
  return {y, impl_->named(history), before.F0};
}

std::vector<material::Gradient<double>> NonlinearBody::deformation(const Interior& now, const TwoPart& q) const {
  const Vector u = impl_->displacement(impl_->deformation(now.y, q));
  return impl_->named([&] { return fem::deformation(impl_->mesh(), impl_->solid, u, now.F0); });
}

std::vector<material::ElasticState> NonlinearBody::elastic_states(const Interior& now, const TwoPart& q) const {
  const Vector u = impl_->displacement(impl_->deformation(now.y, q));
  return impl_->named([&] { return fem::elastic_states(impl_->mesh(), impl_->solid, u, {now.history, now.F0}); });
}

std::vector<material::PlasticState> NonlinearBody::compatible(const Interior& now, const TwoPart& q,
                                                              const std::vector<material::ElasticState>& states) const {
  const Vector u = impl_->displacement(impl_->deformation(now.y, q));
  return impl_->named([&] { return fem::compatible(impl_->mesh(), impl_->solid, u, now.F0, states); });
}

double NonlinearBody::strain_energy(const Interior& now, const TwoPart& q) const {
  const Vector u = impl_->displacement(impl_->deformation(now.y, q));
  return impl_->named([&] { return fem::strain_energy(impl_->mesh(), impl_->solid, u, {now.history, now.F0}); });
}

std::vector<Vec2> NonlinearBody::recover(const TwoPart& q, const TwoPart& y) const {
  return by_node(impl_->displacement(impl_->all(y, q).high));
}

void NonlinearBody::seat(const std::vector<Vec2>& u, Vector& q, TwoPart& y) const {
  const auto& columns = impl_->columns;
  Vector unknowns = impl_->all(y, q).high;
  std::vector<char> held(static_cast<size_t>(unknowns.size()), 0);
  for (const auto& support : columns.supports) held[impl_->interior() + support.column] = 1;
  std::vector<Term> free;
  const base::Points seen = mesh::control_points(columns.curved_edges, u);
  std::vector<const std::vector<Term>*> own;  // of mid nodes in contact: of their control points
  for (const auto& terms : columns.terms) own.push_back(&terms);
  for (size_t k = 0; k < contact_nodes().size(); ++k) own[contact_nodes()[k]] = &columns.seen[k].terms;
  for (size_t node = 0; node < u.size(); ++node) {
    Vec2 rest = seen[node];
    free.clear();
    for (const Term& term : *own[node])
      if (held[term.column])
        rest -= columns.path(term, unknowns[term.column], impl_->turns()).displacement;
      else
        free.push_back(term);
    set_free(free, rest, unknowns);
  }
  y = TwoPart(unknowns.head(y.size()));
  q = unknowns.tail(q.size());
}

Vector NonlinearBody::geometric(const Vector& q, const std::vector<Vec2>& contact_forces) const {
  Vector diagonal = Vector::Zero(dofs());
  if (!impl_->turns()) return diagonal;
  for (size_t k = 0; k < contact_nodes().size(); ++k)
    for (const Term& term : impl_->columns.seen[k].terms) {
      const int column = term.column - impl_->interior();
      diagonal[column] += contact_forces[k].dot(impl_->columns.path(term, q[column], true).curvature);
    }
  return diagonal;
}

}  // namespace reye::body
