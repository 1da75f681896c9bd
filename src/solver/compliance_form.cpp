#include "solver/compliance_form.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/errors.hpp"

namespace reye::solver {

namespace {

/// Share of the stiffness at a support below which what it takes to move the whole body is round-off.
constexpr double rounding = 1e-10;

/// S_ss + S_sn P, zero where a motion of supports costs no force: contact alone resists it.
Matrix stiffness_of_supports(const Eigen::Ref<const Matrix>& S_ss, const Eigen::Ref<const Matrix>& S_sn,
                             const Matrix& P) {
  Matrix T = S_ss;
  T.noalias() += S_sn * P;
  const Vector scale = S_ss.diagonal().cwiseAbs().cwiseSqrt();
  return (T.array().abs() > rounding * (scale * scale.transpose()).array()).select(T, 0.0);
}

}  // namespace

bool ComplianceForm::fits(const System& system, const Reduction& reduction) {
  if (std::exchange(tried_, true)) return fits_;
  fits_ = false;
  const auto may = [](const body::Operator& body) {
    const auto* linear = std::get_if<body::LinearBody>(&body);
    return linear && !linear->turning();
  };
  if (!std::all_of(system.bodies.begin(), system.bodies.end(), may)) return false;
  parts_.assign(system.bodies.size(), {});
  body_of_.assign(static_cast<std::size_t>(reduction.size()), -1);
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    const int body = static_cast<int>(b);
    if (!take(system, reduction, body, parts_[b])) return false;
    const auto own = body_of_.begin() + parts_[b].first;
    std::fill(own, own + parts_[b].nodes + parts_[b].supports, body);
  }
  return fits_ = true;
}

/// The compliance of a linear body that keeps its direction, or false where it has none.
bool ComplianceForm::take(const System& system, const Reduction& reduction, int body, Part& part) {
  const auto& linear = std::get<body::LinearBody>(system.bodies[body]);
  const Matrix& S = reduction.stiffness(body);
  part.first = reduction.first(body);
  part.supports = static_cast<int>(linear.support_columns().size());
  part.nodes = static_cast<int>(S.rows()) - part.supports;
  part.C = S.topLeftCorner(part.nodes, part.nodes);
  try {
    algebra::invert_held(part.C);
  } catch (const base::SolveError&) {  // contact alone holds the body
    return false;
  }
  const auto S_ss = S.bottomRightCorner(part.supports, part.supports);
  part.P.noalias() = -part.C * S.topRightCorner(part.nodes, part.supports);
  part.T = stiffness_of_supports(S_ss, S.bottomLeftCorner(part.supports, part.nodes), part.P);
  part.unit = (S_ss.diagonal().array() > 0.0).select(S_ss.diagonal().cwiseInverse(), 1.0);
  return true;
}

/// The unknowns of a contact's multipliers, by its linearised conditions.
void ComplianceForm::choose_unknowns(int contact, const contact::Interface& face) {
  const auto count = static_cast<std::size_t>(face.setup().secondary_count());
  const int positions = face.dofs();
  std::vector<Vec2> own(count, Vec2::Zero());  // slope of the tangential condition by the node's own traction
  std::vector<char> alone(count, 1);
  for (const auto& e : linearised_[contact].rows) {
    if (e.row % 2 == 0) continue;
    const int node = e.row / 2, component = e.col - positions - 2 * node;
    if (component == 0 || component == 1)
      own[node][component] += e.value;
    else
      alone[node] = 0;
  }
  auto& multipliers = multipliers_[contact];
  multipliers.assign(count, {});
  for (std::size_t j = 0; j < count; ++j) {
    const int node = static_cast<int>(j);
    if (!face.active(node)) continue;
    multipliers[j].count = 2;
    if (!alone[j] || own[j].isZero(0.0)) continue;
    multipliers[j].count = 1;
    multipliers[j].along[0] = Vec2(-own[j].y(), own[j].x()).normalized();
    multipliers[j].met = static_cast<int>(met_.size());
    met_.push_back({contact, node, own[j] / own[j].squaredNorm(), {}, {}});
  }
}

/// Numbers the unknowns of all multipliers, with their conditions.
void ComplianceForm::number() {
  int count = 0;
  for (auto& of_contact : multipliers_)
    for (auto& multiplier : of_contact) {
      multiplier.first = count;
      count += multiplier.count;
    }
  conditions_.resize(static_cast<std::size_t>(count));  // they keep the memory of their lists
  for (std::size_t c = 0; c < multipliers_.size(); ++c)
    for (std::size_t j = 0; j < multipliers_[c].size(); ++j)
      for (int t = 0; t < multipliers_[c][j].count; ++t) {
        auto& condition = conditions_[multipliers_[c][j].first + t];
        condition.contact = static_cast<int>(c);
        condition.row = 2 * static_cast<int>(j) + t;
        condition.slope.clear();
      }
}

/// The support columns that nothing prescribes.
void ComplianceForm::find_free(const Controls& controls, const Reduction& reduction) {
  std::vector<char> given(body_of_.size(), 0);
  for (const auto& [column, value] : controls.prescribed) given[reduction.index(column)] = 1;
  free_.clear();
  for (const auto& part : parts_) {
    for (int k = part.first; k < part.support(); ++k)
      if (given[k]) throw std::logic_error("the column of a contact node is prescribed");
    for (int k = part.support(); k < part.support() + part.supports; ++k)
      if (!given[k]) free_.push_back(k);
  }
}

/// Motions by the free support columns, and the balance of these.
void ComplianceForm::move_supports(const Controls& controls, const Reduction& reduction) {
  const auto before = static_cast<int>(conditions_.size());
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const int unknown = before + static_cast<int>(i), column = free_[i];
    const Part& part = part_of(column);
    const int k = column - part.support();
    motion_.row(unknown).segment(part.first, part.nodes) = part.unit[k] * part.P.col(k).transpose();
    motion_(unknown, column) = part.unit[k];
    for (std::size_t j = 0; j < free_.size(); ++j)
      if (&part_of(free_[j]) == &part)
        At_(unknown, before + static_cast<int>(j)) = part.T(free_[j] - part.support(), k) * part.unit[k];
    for (const auto& spring : controls.springs)
      if (reduction.index(spring.column) == column) At_(unknown, unknown) += spring.stiffness * part.unit[k];
  }
}

/// The force of a multiplier, times a factor, on a node: it moves that one's body and loads the free supports.
void ComplianceForm::load(const PlacedNode& node, const Multiplier& multiplier, double factor) {
  const auto before = static_cast<int>(conditions_.size());
  for (int t = 0; t < node.position.count; ++t) {
    const Vec2 force = factor * node.position.terms[t].direction;
    const int column = node.column[t];
    const Part& part = part_of(column);
    for (int i = 0; i < multiplier.count; ++i) {
      const int unknown = multiplier.first + i;
      const double weight = force.dot(multiplier.along[i]);
      if (weight == 0.0) continue;
      if (column < part.support())
        motion_.row(unknown).segment(part.first, part.nodes) -= weight * part.C.col(column - part.first).transpose();
      for (std::size_t k = 0; k < free_.size(); ++k) {
        const int equation = before + static_cast<int>(k);
        const Part& moved = part_of(free_[k]);
        At_(unknown, equation) += weight * motion_(equation, column) / moved.unit[free_[k] - moved.support()];
      }
    }
    if (multiplier.met >= 0) met_[multiplier.met].forces.emplace_back(column, force.dot(met_[multiplier.met].step));
  }
}

/// Conditions of a contact: their slopes by multipliers go into the matrix, those by positions into lists.
void ComplianceForm::add_conditions(int contact, const contact::Interface& face, const std::vector<PlacedNode>& nodes) {
  const auto& multipliers = multipliers_[contact];
  for (const auto& e : linearised_[contact].rows) {
    const auto& own = multipliers[e.row / 2];
    if (e.row % 2 >= own.count) continue;  // met beforehand
    const int equation = own.first + e.row % 2;
    if (const int beyond = e.col - face.dofs(); beyond >= 0) {
      const auto& other = multipliers[beyond / 2];
      for (int i = 0; i < other.count; ++i) At_(other.first + i, equation) += e.value * other.along[i][beyond % 2];
      if (other.met < 0) continue;
      auto& met = met_[other.met];
      met.slopes.emplace_back(equation, e.value * met.step[beyond % 2]);
      continue;
    }
    const auto& node = nodes[e.col / 2];
    for (int t = 0; t < node.position.count; ++t)
      if (const double share = node.position.terms[t].direction[e.col % 2]; share != 0.0)
        conditions_[equation].slope.emplace_back(inside(node.column[t]), share * e.value);
  }
}

/// Adds up the slopes of each condition, in which a column stands once for each way that it acts, and inserts the
/// motions.
void ComplianceForm::close_conditions() {
  slope_.setZero(motion_.cols());
  for (std::size_t k = 0; k < conditions_.size(); ++k) {
    auto& slope = conditions_[k].slope;
    for (const auto& [column, value] : slope) slope_[column] += value;
    std::size_t kept = 0;
    for (const auto& entry : slope)
      if (const double sum = std::exchange(slope_[entry.first], 0.0); sum != 0.0) slope[kept++] = {entry.first, sum};
    slope.resize(kept);
    for (const auto& [column, value] : slope) At_.col(static_cast<Eigen::Index>(k)) += value * motion_.col(column);
  }
}

void ComplianceForm::factor(const Controls& controls, const Reduction& reduction,
                            std::vector<contact::Interface>& faces, const std::vector<std::vector<PlacedNode>>& nodes,
                            const Multipliers& lambda) {
  met_.clear();
  linearised_.resize(faces.size());
  multipliers_.resize(faces.size());
  for (std::size_t c = 0; c < faces.size(); ++c) {
    faces[c].linearise(lambda[c], linearised_[c], contact::Derivatives::held_integrals);
    choose_unknowns(static_cast<int>(c), faces[c]);
  }
  number();
  find_free(controls, reduction);
  const auto unknowns = static_cast<Eigen::Index>(conditions_.size() + free_.size());
  motion_.setZero(unknowns, reduction.size());
  At_.setZero(unknowns, unknowns);
  move_supports(controls, reduction);
  for (std::size_t c = 0; c < faces.size(); ++c) {
    const auto secondary = multipliers_[c].size();
    for (std::size_t j = 0; j < secondary; ++j) {
      const auto& multiplier = multipliers_[c][j];
      if (multiplier.count == 0) continue;
      const auto& row = faces[c].rows()[j];
      load(nodes[c][j], multiplier, row.D);
      for (const auto& [k, share] : row.off) load(nodes[c][k], multiplier, share);
      for (const auto& [l, M] : row.M) load(nodes[c][secondary + l], multiplier, -M);
    }
    add_conditions(static_cast<int>(c), faces[c], nodes[c]);
  }
  close_conditions();
  factor_.factor(At_);
}

Vector ComplianceForm::solve(const Controls& controls, const Reduction& reduction,
                             const std::vector<contact::Interface>& faces, Vector b, const base::TwoPart& q,
                             Multipliers& lambda) const {
  const auto before = static_cast<Eigen::Index>(conditions_.size());
  Vector dq = Vector::Zero(b.size()), rhs(before + static_cast<Eigen::Index>(free_.size()));
  for (const auto& [column, value] : controls.prescribed) {
    const int at = reduction.index(column);
    dq[at] = value - q.high[at] - q.low[at];
  }
  std::vector<double> unmet;
  for (const auto& met : met_) {
    unmet.push_back(-faces[met.contact].residual_tangential(met.node));
    for (const auto& [column, force] : met.forces) b[column] -= force * unmet.back();
  }
  for (const auto& part : parts_) {
    const Vector given = dq.segment(part.support(), part.supports);
    auto moved = dq.segment(part.first, part.nodes);
    moved.noalias() = part.C * b.segment(part.first, part.nodes);
    moved.noalias() += part.P * given;
    b.segment(part.support(), part.supports).noalias() += part.P.transpose() * b.segment(part.first, part.nodes);
    b.segment(part.support(), part.supports).noalias() -= part.T * given;
  }
  for (std::size_t i = 0; i < free_.size(); ++i) rhs[before + static_cast<Eigen::Index>(i)] = b[free_[i]];
  for (Eigen::Index k = 0; k < before; ++k) {
    const auto& condition = conditions_[static_cast<std::size_t>(k)];
    const auto& face = faces[condition.contact];
    const int node = condition.row / 2;
    rhs[k] = -(condition.row % 2 == 0 ? face.residual_normal(node) : face.residual_tangential(node));
    for (const auto& [column, value] : condition.slope) rhs[k] -= value * dq[column];
  }
  for (std::size_t i = 0; i < met_.size(); ++i)
    for (const auto& [equation, slope] : met_[i].slopes) rhs[equation] -= slope * unmet[i];
  const Vector step = factor_.solve_transposed(rhs);
  dq.noalias() += motion_.transpose() * step;
  for (std::size_t c = 0; c < lambda.size(); ++c)
    for (std::size_t j = 0; j < lambda[c].size(); ++j) {
      const auto& multiplier = multipliers_[c][j];
      if (multiplier.count == 0) lambda[c][j].setZero();
      for (int i = 0; i < multiplier.count; ++i) lambda[c][j] += step[multiplier.first + i] * multiplier.along[i];
      if (multiplier.met >= 0) lambda[c][j] += unmet[multiplier.met] * met_[multiplier.met].step;
    }
  return dq;
}

}  // namespace reye::solver
