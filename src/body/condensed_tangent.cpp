#include "body/condensed_tangent.hpp"

#include <algorithm>
#include <utility>

#include "algebra/congruence.hpp"

namespace reye::body {

using base::SparseMatrix;

namespace {

constexpr int margin = 3;          ///< rings of cells that change beside those that have
constexpr double largest = 0.5;    ///< share of the cells beyond which all tangents are made again
constexpr int remembered = 200;    ///< tangents for which a cell counts as changing
constexpr int longest_wait = 256;  ///< tangents of all cells before another division is tried
/// Turn and stretch since its tangent was kept at which a cell counts as changed: the error of Newton's steps, times
/// the square of slenderness in bending.
constexpr double much = 0.005;
/// Turn and stretch of a single cell at which its tangent is made again: at 0.001 a rivet takes 6 % less time, but a
/// belt that bends round a drum 6.0 iterations an increment in place of 5.6, and at 0.0003 an increment of rubber with
/// a factor c of 1e4 no longer converges.
constexpr double hardly = 0.0001;

/// The columns of a sparse matrix that are listed.
SparseMatrix chosen(const SparseMatrix& B, const std::vector<int>& columns) {
  std::vector<base::Triplet> entries;
  for (std::size_t c = 0; c < columns.size(); ++c)
    for (SparseMatrix::InnerIterator e(B, columns[c]); e; ++e)
      entries.emplace_back(static_cast<int>(e.row()), static_cast<int>(c), e.value());
  SparseMatrix part(B.rows(), static_cast<Eigen::Index>(columns.size()));
  part.setFromTriplets(entries.begin(), entries.end());
  return part;
}

void add_to_diagonal(const Vector& terms, SparseMatrix& K) {
  for (Eigen::Index c = 0; c < terms.size(); ++c)
    if (terms[c] != 0.0) K.coeffRef(c, c) += terms[c];
}

mesh::Mesh cells_of(const mesh::Mesh& mesh, const std::vector<char>& wanted) {
  mesh::Mesh part;
  part.X = mesh.X;
  part.kind = mesh.kind;
  for (std::size_t cell = 0; cell < wanted.size(); ++cell)
    if (wanted[cell]) part.cells.push_back(mesh.cells[cell]);
  return part;
}

/// Whether an edge of a cell has turned or stretched by a share of its length. `moved(corner)`: its displacement.
template <class Moved>
bool has_moved(const mesh::Mesh& mesh, std::size_t cell, double share, Moved moved) {
  const auto& nodes = mesh.cells[cell];
  for (int a = mesh::corners(mesh.kind) - 1, b = 0; b < mesh::corners(mesh.kind); a = b++)
    if ((moved(b) - moved(a)).norm() > share * (mesh.X[nodes[b]] - mesh.X[nodes[a]]).norm()) return true;
  return false;
}

/// Adds the rings of cells around those that are marked.
void widen(const mesh::Mesh& mesh, const std::vector<std::vector<int>>& cells_of, std::vector<char>& marked) {
  const int count = mesh::nodes_per_cell(mesh.kind);
  for (int ring = 0; ring < margin; ++ring) {
    const auto before = marked;
    for (std::size_t cell = 0; cell < before.size(); ++cell)
      if (before[cell])
        for (int a = 0; a < count; ++a)
          for (const int beside : cells_of[static_cast<std::size_t>(mesh.cells[cell][a])])
            marked[static_cast<std::size_t>(beside)] = 1;
  }
}

}  // namespace

CondensedTangent::CondensedTangent(const NonlinearEquations& of)
    : cells_of_(static_cast<std::size_t>(of.mesh().node_count())),
      cells_(fem::cell_tangents(of.mesh())),
      made_for_(base::Matrix::Zero(8, of.mesh().cell_count())),
      yielded_(of.mesh().cells.size(), 1),
      last_(of.mesh().cells.size(), -remembered) {
  for (int cell = 0; cell < of.mesh().cell_count(); ++cell)
    for (int a = 0; a < mesh::nodes_per_cell(of.mesh().kind); ++a)
      cells_of_[static_cast<std::size_t>(of.mesh().cells[cell][a])].push_back(cell);
}

void CondensedTangent::forget() {
  divided_ = false;
  rest_.reset();
  kept_at_.resize(0);
  yielded_.assign(yielded_.size(), 1);
  last_.assign(last_.size(), -remembered);
  made_ = divided_at_ = whole_until_ = 0;
  wait_ = 4;
}

void CondensedTangent::measure(const NonlinearEquations& of, const Interior& before, const Vector& v,
                               const Vector& load_factors) {
  at_.v = v;
  at_.u = of.displacement(v);
  at_.load_factors = load_factors;
  of.named([&] { fem::internal_force(of.mesh(), of.solid, at_.u, {before.history, before.F0}, f, &at_.yields); });
  for (std::size_t cell = 0; cell < yielded_.size(); ++cell) yielded_[cell] |= at_.yields[cell];
  at_.unbalanced = of.unbalanced(f, at_.u, load_factors);
  if (at_.B.size() == 0 || of.turns()) at_.B = of.expansion(v);
  r = at_.B.transpose() * at_.unbalanced;
}

void CondensedTangent::make(const NonlinearEquations& of, const Interior& before, Tangent tangent) {
  ++made_;
  divided_ = false;  // also where what follows throws
  divided_ = divides(of) && make_rest(of, before, tangent);
  if (!divided_) make_whole(of, before, tangent);
  made_at_ = at_.v;
}

double CondensedTangent::left_out(const NonlinearEquations& of) const {
  if (of.symmetric()) return 0.0;
  const Vector step = at_.v - made_at_;
  double largest = 0.0;
  if (!divided_) {
    const Vector forces = whole_.condensation.left_out(whole_.reduced, step);
    return of.interior() > 0 ? forces.head(of.interior()).cwiseAbs().maxCoeff() : 0.0;
  }
  const Vector forces = rest_->condensation.left_out(rest_->reduced, step(rest_->columns));
  for (std::size_t c = 0; c < rest_->columns.size(); ++c)
    if (rest_->columns[c] < of.interior()) largest = std::max(largest, std::abs(forces[static_cast<Eigen::Index>(c)]));
  return largest;
}

bool CondensedTangent::divides(const NonlinearEquations& of) const {
  const bool follows = std::any_of(of.loads.begin(), of.loads.end(),
                                   [](const NonlinearLoad& load) { return load.pressure.has_value(); });
  return !follows && made_ > whole_until_;
}

/// Makes the tangents of those cells that have yielded, or turned or stretched, since theirs was made; where exact ones
/// are asked for, of all that are wanted.
void CondensedTangent::renew_cells(const NonlinearEquations& of, const Interior& before, Tangent tangent,
                                   const Flags& wanted) {
  const auto& mesh = of.mesh();
  const int corners = mesh::corners(mesh.kind);
  const auto moved = [&](std::size_t cell) {
    return has_moved(mesh, cell, hardly, [&](int a) -> base::Vec2 {
      const auto made_for = made_for_.col(static_cast<Eigen::Index>(cell));
      return at_.u.segment<2>(2 * mesh.cells[cell][a]) - made_for.segment<2>(2 * a);
    });
  };
  Flags due(wanted.size());
  const bool exact = tangent == Tangent::exact;
  for (std::size_t cell = 0; cell < due.size(); ++cell) {
    due[cell] = wanted[cell] && (yielded_[cell] || (of.turns() && (exact || moved(cell))));
    if (due[cell]) yielded_[cell] = 1;  // until it is made: what follows may throw
  }
  of.named([&] { fem::renew(mesh, of.solid, at_.u, {before.history, before.F0}, due, cells_); });
  for (std::size_t cell = 0; cell < due.size(); ++cell) {
    if (!due[cell]) continue;
    yielded_[cell] = at_.yields[cell];
    for (int a = 0; a < corners; ++a)
      made_for_.col(static_cast<Eigen::Index>(cell)).segment<2>(2 * a) = at_.u.segment<2>(2 * mesh.cells[cell][a]);
  }
}

void CondensedTangent::make_whole(const NonlinearEquations& of, const Interior& before, Tangent tangent) {
  const auto& [v, u, load_factors, unbalanced, B, yields] = at_;
  if (whole_.K.size() == 0) whole_.K = of.pattern.zero();
  renew_cells(of, before, tangent, Flags(yielded_.size(), 1));
  fem::assemble(of.mesh(), cells_, {}, of.pattern, whole_.K);
  of.subtract_load_tangent(u, load_factors, whole_.K);
  algebra::congruence(whole_.K, B, whole_.reduced);
  add_to_diagonal(of.turning(unbalanced, v), whole_.reduced);
  of.named([&] { whole_.condensation.factorise(whole_.reduced, of.columns.retained, of.symmetric(), tangent); });
  changing = 1.0;
}

/// The cells that have changed: those that yield, or have turned or stretched since their tangent was kept.
CondensedTangent::Flags CondensedTangent::changed(const NonlinearEquations& of) {
  Flags marked = at_.yields;
  const auto& mesh = of.mesh();
  if (of.turns() && kept_at_.size() > 0) {
    for (std::size_t cell = 0; cell < marked.size(); ++cell)
      if (has_moved(mesh, cell, much, [&](int a) -> base::Vec2 {
            const int node = mesh.cells[cell][a];
            return at_.u.segment<2>(2 * node) - kept_at_.segment<2>(2 * node);
          }))
        marked[cell] = 1;
  }
  for (std::size_t cell = 0; cell < marked.size(); ++cell)
    if (marked[cell]) last_[cell] = made_;
  return marked;
}

/// Chooses the cells that change, and condenses the others there. False where that would not pay.
bool CondensedTangent::divide(const NonlinearEquations& of, const Interior& before, Tangent tangent) {
  changing_.assign(last_.size(), 0);
  for (std::size_t cell = 0; cell < last_.size(); ++cell) changing_[cell] = made_ - last_[cell] < remembered;
  widen(of.mesh(), cells_of_, changing_);
  const auto count = std::count(changing_.begin(), changing_.end(), 1);
  if (static_cast<double>(count) > largest * static_cast<double>(changing_.size())) return false;
  changing = static_cast<double>(count) / static_cast<double>(changing_.size());

  Flags kept(changing_.size());
  std::transform(changing_.begin(), changing_.end(), kept.begin(), [](char c) { return !c; });
  std::vector<char> inside(static_cast<std::size_t>(of.columns.interior + of.columns.retained), 1);
  std::fill(inside.begin() + of.columns.interior, inside.end(), 0);
  for (std::size_t node = 0; node < cells_of_.size(); ++node)
    for (const int cell : cells_of_[node])
      if (changing_[static_cast<std::size_t>(cell)])
        for (const Term& term : of.columns.terms[node]) inside[static_cast<std::size_t>(term.column)] = 0;
  renew_cells(of, before, tangent, kept);
  fem::assemble(of.mesh(), cells_, kept, of.pattern, whole_.K);
  try {
    SparseMatrix reduced;
    algebra::congruence(whole_.K, at_.B, reduced);
    Superelement element(reduced, inside, of.symmetric(), tangent);
    std::vector<int> columns, place(inside.size(), -1);
    for (std::size_t c = 0; c < inside.size(); ++c) {
      if (inside[c]) continue;
      place[c] = static_cast<int>(columns.size());
      columns.push_back(static_cast<int>(c));
    }
    const auto& shared = element.shared();
    std::vector<base::Triplet> entries;
    for (std::size_t i = 0; i < shared.size(); ++i)
      for (std::size_t j = 0; j < shared.size(); ++j)
        entries.emplace_back(place[static_cast<std::size_t>(shared[i])], place[static_cast<std::size_t>(shared[j])],
                             element.stiffness()(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    const auto size = static_cast<Eigen::Index>(columns.size());
    SparseMatrix stiffness(size, size);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    fem::Pattern pattern(cells_of(of.mesh(), changing_));
    SparseMatrix K = pattern.zero(), own = chosen(at_.B, columns);
    rest_.emplace(Rest{std::move(element),
                       tangent,
                       std::move(columns),
                       std::move(own),
                       std::move(pattern),
                       std::move(K),
                       std::move(stiffness),
                       {},
                       {}});
  } catch (const base::SolveError&) {
    return false;  // singular
  }
  kept_at_ = at_.u;
  return true;
}

bool CondensedTangent::make_rest(const NonlinearEquations& of, const Interior& before, Tangent tangent) {
  if (whole_.K.size() == 0) whole_.K = of.pattern.zero();
  const Flags marked = changed(of);
  const auto outside = [&] {
    for (std::size_t cell = 0; cell < marked.size(); ++cell)
      if (marked[cell] && !changing_[cell]) return true;
    return false;
  };
  const bool enough = rest_ && (rest_->kept_as == tangent || rest_->kept_as == Tangent::exact || !of.turns());
  if (!enough || outside()) {
    rest_.reset();
    wait_ = made_ - divided_at_ > 8 ? 4 : std::min(2 * wait_, longest_wait);
    divided_at_ = made_;
    if (!divide(of, before, tangent)) {
      rest_.reset();
      kept_at_.resize(0);
      whole_until_ = made_ + wait_;
      return false;
    }
  } else if (of.turns()) {
    rest_->B = chosen(at_.B, rest_->columns);
  }
  renew_cells(of, before, tangent, changing_);
  fem::assemble(of.mesh(), cells_, changing_, rest_->pattern, rest_->K);
  algebra::congruence(rest_->K, rest_->B, rest_->reduced);
  rest_->reduced += rest_->kept_stiffness;
  add_to_diagonal(of.turning(at_.unbalanced, at_.v)(rest_->columns), rest_->reduced);
  of.named([&] { rest_->condensation.factorise(rest_->reduced, of.columns.retained, of.symmetric(), tangent); });
  return true;
}

/// Forces of the kept cells up to this size are round-off, as nearly all of them are at small strain: condensing them
/// costs as much as a step, and changes nothing.
double CondensedTangent::negligible() const { return 1e-12 * f.largest; }

Vector CondensedTangent::condense(const Vector& all) const {
  if (!divided_) return whole_.condensation.condense(all);
  Vector loads = all;
  rest_->kept.condense(loads, negligible());
  return rest_->condensation.condense(loads(rest_->columns));
}

Vector CondensedTangent::recover(const Vector& all, const Vector& retained) const {
  if (!divided_) return whole_.condensation.recover(all, retained);
  Vector loads = all, unknowns = Vector::Zero(all.size());
  rest_->kept.condense(loads, negligible());
  unknowns(rest_->columns) = rest_->condensation.recover(loads(rest_->columns), retained);
  rest_->kept.recover(all, unknowns);
  return unknowns;
}

}  // namespace reye::body
