#include <cassert>
#include <mutex>
#include <utility>

#include "algebra/congruence.hpp"
#include "body/columns.hpp"
#include "body/operator.hpp"
#include "body/turning.hpp"
#include "fem/assemble_loads.hpp"
#include "fem/stiffness.hpp"

namespace reye::body {

using base::SparseMatrix;

namespace {

/// A load on the unknowns y and condensed to q (for history factor 1).
struct CondensedLoad {
  Vector full;
  Vector condensed;
};

/// One load of the scene: the part that turns with the body, and the rest at theta = 0 and a quarter turn later. For a
/// body that keeps its direction all of it is `still`.
struct BodyLoad {
  CondensedLoad still;
  std::optional<CondensedLoad> along, across;
};

}  // namespace

struct LinearBody::Impl {
  ShapePtr shape;
  std::optional<Pivot> pivot;
  Columns columns;  ///< without terms
  SparseMatrix B;
  algebra::SchurFactor factor;
  std::optional<Matrix> with_angle;  ///< S with an empty row and column for theta, where no support names it
  Translation translation;
  std::optional<Turning> turning;
  std::vector<LoadColumn> names;
  std::vector<BodyLoad> loads;
  mutable std::once_flag inverted;
  mutable std::shared_ptr<const algebra::Compliance> compliance;

  Impl(ShapePtr s, const BodyInput& input, algebra::SchurAnalysisPtr known)
      : shape(std::move(s)),
        pivot(pivot_of(shape->mesh, input)),
        columns(number_columns(shape->mesh, input, chord(input))),
        B(expansion()),
        factor(reduced_stiffness(input), columns.retained, std::move(known)) {
    if (own_angle()) {
      with_angle = Matrix::Zero(dofs(), dofs());
      with_angle->topLeftCorner(columns.retained, columns.retained) = factor.schur();
    }
    Matrix T = Matrix::Zero(dofs(), 2);
    T.topRows(columns.retained) = columns.translations(input.analysis).bottomRows(columns.retained);
    translation = Translation(T);
    if (pivot) turning = set_turning();
    for_each_load(input, [&](const auto& load) {
      names.push_back({load.name, load.history});
      if (!turning) {
        loads.push_back({condensed(fem::load_vector(shape->mesh, input.analysis, load)), {}, {}});
        return;
      }
      const TurningLoad nodal = nodal_load(shape->mesh, input.analysis, load);
      loads.push_back({condensed(nodal.still), condensed(nodal.along), condensed(nodal.across)});
    });
  }

  bool own_angle() const { return pivot && !pivot->names_angle; }
  int dofs() const { return columns.retained + own_angle(); }
  const Matrix& S() const { return with_angle ? *with_angle : factor.schur(); }

  std::vector<int> chord(const BodyInput& input) const {
    if (!own_angle()) return {};
    const auto [a, b] = chord_nodes(shape->mesh, input, *pivot);
    return {a, b};
  }

  /// B; the terms that it was made of are released.
  SparseMatrix expansion() {
    SparseMatrix expansion = columns.expansion();
    columns.terms = {};
    return expansion;
  }

  /// B^T K B
  SparseMatrix reduced_stiffness(const BodyInput& input) const {
    SparseMatrix reduced;
    algebra::congruence(fem::stiffness(shape->mesh, input.material, input.analysis, input.b_bar), B, reduced);
    return reduced;
  }

  Turning set_turning() const {
    Turning t;
    t.centre = pivot->centre;
    t.hand = pivot->hand;
    t.angle = own_angle() ? columns.retained : -1;
    for (const SupportColumn& s : columns.supports) {
      if (s.support != pivot->support) continue;
      (s.motion == 2 ? t.angle : t.pivot[s.motion]) = s.column;
    }
    if (!own_angle()) return t;
    const auto end = columns.seen.end();
    const ContactNode &a = *(end - 2), &b = *(end - 1);
    const Vec2 along = b.X - a.X, across = Vec2{-along.y(), along.x()}.normalized();
    for (const auto& [node, sign] : {std::pair(&a, -1.0), std::pair(&b, 1.0)})
      for (const Term& term : node->terms)
        t.chord.emplace_back(term.column - columns.interior, sign * across.dot(term.direction));
    return t;
  }

  CondensedLoad condensed(const Vector& nodal) const {
    CondensedLoad load;
    load.full = B.transpose() * nodal;
    load.condensed = Vector::Zero(dofs());
    load.condensed.head(columns.retained) = factor.condense(load.full);
    return load;
  }

  TurningLoad turning_load(const Vector& factors, Vector CondensedLoad::*of) const {
    const Eigen::Index n = of == &CondensedLoad::full ? B.cols() : dofs();
    TurningLoad sum{Vector::Zero(n), Vector::Zero(n), Vector::Zero(n)};
    for (size_t i = 0; i < loads.size(); ++i) {
      sum.still += factors[i] * loads[i].still.*of;
      if (!loads[i].along) continue;
      sum.along += factors[i] * (*loads[i].along).*of;
      sum.across += factors[i] * (*loads[i].across).*of;
    }
    return sum;
  }

  /// Forces on w that are out of balance.
  Vector forces(const Vector& q, const Vector& factors) const {
    if (!turning) return S() * q - turning_load(factors, &CondensedLoad::condensed).still;
    return S() * turning->in_frame(q) - turning_load(factors, &CondensedLoad::condensed).at(q[turning->angle]);
  }

  Vec2 turned(const Vec2& X, const Vec2& w, double angle) const {
    return turning->centre + rotation(angle) * (X + w - turning->centre);
  }
};

LinearBody::LinearBody(ShapePtr shape, const BodyInput& input, algebra::SchurAnalysisPtr known)
    : impl_(std::make_shared<const Impl>(std::move(shape), input, std::move(known))) {}

const algebra::SchurAnalysisPtr& LinearBody::analysis() const { return impl_->factor.analysis(); }
int LinearBody::dofs() const { return impl_->dofs(); }
int LinearBody::full_dofs() const { return impl_->columns.interior + impl_->columns.retained; }
const std::vector<int>& LinearBody::contact_nodes() const { return impl_->columns.contact_nodes; }
const Matrix& LinearBody::stiffness() const { return impl_->S(); }
std::shared_ptr<const Matrix> LinearBody::shared_stiffness() const { return {impl_, &impl_->S()}; }

std::shared_ptr<const algebra::Compliance> LinearBody::compliance() const {
  std::call_once(impl_->inverted, [this] {
    std::vector<int> held;
    if (impl_->turning)
      held = impl_->turning->named();
    else
      for (const auto& support : impl_->columns.supports) held.push_back(support.column);
    try {
      impl_->compliance = std::make_shared<const algebra::Compliance>(impl_->S(), held);
    } catch (const base::SolveError&) {  // S serves as well, at the price of all columns that are left out
    }
  });
  return impl_->compliance;
}

const Turning* LinearBody::turning() const { return impl_->turning ? &*impl_->turning : nullptr; }
double LinearBody::angle(const Vector& q) const { return impl_->turning ? q[impl_->turning->angle] : 0.0; }
const Translation& LinearBody::translation() const { return impl_->translation; }
const std::vector<SupportColumn>& LinearBody::support_columns() const { return impl_->columns.supports; }
const std::vector<LoadColumn>& LinearBody::loads() const { return impl_->names; }
const std::vector<mesh::LineFacet>& LinearBody::curved_edges() const { return impl_->columns.curved_edges; }

NodePosition LinearBody::position(ContactIndex at, const Vector& q) const {
  const ContactNode& node = impl_->columns.node(at);
  NodePosition p;
  p.x = node.X;
  for (Term term : node.terms) {
    term.column -= impl_->columns.interior;  // from the unknowns y to q: all columns of a contact node are retained
    if (!impl_->turning || term.column != impl_->turning->angle) p.x += q[term.column] * term.direction;
    p.terms[p.count++] = term;
  }
  if (!impl_->turning) return p;
  const Turning& turning = *impl_->turning;
  const Eigen::Matrix2d R = rotation(q[turning.angle]);
  p.angle = turning.angle;
  if (node.freedom.free == 0) {  // of the pivot
    const Vec2 arm = node.X - turning.centre;
    p.x += R * arm - arm;
    p.turned = 2;
    if (p.count > 2) p.terms[2].direction = R * p.terms[2].direction;
    return p;
  }
  const Vec2 arm = R * (p.x - turning.centre);
  p.x = turning.centre + arm;
  p.swing = {-arm.y(), arm.x()};
  p.turned = 0;
  for (int t = 0; t < p.count; ++t) p.terms[t].direction = R * p.terms[t].direction;
  return p;
}

NodeFreedom LinearBody::freedom(ContactIndex at) const { return impl_->columns.node(at).freedom; }

Vector LinearBody::residual(const Vector& q, const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  Vector r = impl_->forces(q, load_factors);
  if (!impl_->turning) return r;
  impl_->turning->to_axes(q[impl_->turning->angle], r);
  if (!impl_->turning->chord.empty()) r[impl_->turning->angle] = impl_->turning->chord_of(q);
  return r;
}

Matrix LinearBody::tangent(const Vector& q, const Vector& load_factors) const {
  if (!impl_->turning) return impl_->S();
  const Turning& turning = *impl_->turning;
  const Vector none = Vector::Zero(static_cast<Eigen::Index>(impl_->loads.size()));
  const Vector& factors = load_factors.size() > 0 ? load_factors : none;
  Matrix transposed = impl_->S();
  turning.turn(q, impl_->forces(q, factors), turning_load(factors).rate(q[turning.angle]), transposed);
  if (!turning.chord.empty()) transposed.col(turning.angle).setZero();
  for (const auto& [column, factor] : turning.chord) transposed(column, turning.angle) = factor;
  return transposed.transpose();
}

Vector LinearBody::load(const Vector& load_factors) const { return turning_load(load_factors).still; }

TurningLoad LinearBody::turning_load(const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  return impl_->turning_load(load_factors, &CondensedLoad::condensed);
}

double LinearBody::strain_energy(const Vector& q) const {
  const Vector w = impl_->turning ? impl_->turning->in_frame(q) : q;
  return 0.5 * w.dot(impl_->S() * w);
}

Vector LinearBody::at_supports(const TwoPart& q, const Vector& load_factors) const {
  const Turning* turning = this->turning();
  const TwoPart w = turning ? turning->in_frame(q) : q;
  const Vector v = translation().without(w);
  const double angle = this->angle(q.high);
  const TurningLoad load = turning_load(load_factors);
  Vector r = Vector::Zero(dofs());
  for (const SupportColumn& support : support_columns()) {
    const int k = support.column;
    r[k] = impl_->S().col(k).dot(v) - load.still[k];
    if (turning) r[k] -= std::cos(angle) * load.along[k] + std::sin(angle) * load.across[k];
  }
  if (turning) turning->to_axes(angle, r);
  return r;
}

std::vector<Vec2> LinearBody::recover_in_frame(const Vector& q, const Vector& load_factors) const {
  assert(load_factors.size() == static_cast<Eigen::Index>(impl_->loads.size()));
  const Vector f = impl_->turning_load(load_factors, &CondensedLoad::full).at(angle(q));
  const Vector w = impl_->turning ? impl_->turning->in_frame(q) : q;
  std::vector<Vec2> nodal(impl_->shape->mesh.X.size(), Vec2::Zero());
  if (f.isZero(0.0) && w.isZero(0.0)) return nodal;  // as drawn
  const Vector u = impl_->B * impl_->factor.recover(f, w.head(impl_->columns.retained));
  for (size_t node = 0; node < nodal.size(); ++node) nodal[node] = u.segment<2>(2 * node);
  return nodal;
}

std::vector<Vec2> LinearBody::recover(const Vector& q, const Vector& load_factors) const {
  auto u = recover_in_frame(q, load_factors);
  const auto& X = impl_->shape->mesh.X;
  if (impl_->turning)
    for (size_t node = 0; node < u.size(); ++node) u[node] = impl_->turned(X[node], u[node], angle(q)) - X[node];
  return u;
}

}  // namespace reye::body
