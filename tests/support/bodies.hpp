#pragma once
#include <string>
#include <vector>

#include "body/operator.hpp"
#include "fem/assemble_loads.hpp"

/// Bodies and a plain solve of one linear body, for tests of all rooms.
namespace reye::support {

inline body::BodyInput made_of(const material::Material& material, base::Kinematics kinematics,
                               base::Analysis analysis = base::Analysis::plane_strain) {
  body::BodyInput input;
  input.name = "body";
  input.material = material;
  input.analysis = analysis;
  input.kinematics = kinematics;
  return input;
}

inline body::BodyInput elastic(double E_MPa, double nu, base::Analysis analysis = base::Analysis::plane_strain) {
  return made_of(material::LinearElastic{E_MPa, nu}, base::Kinematics::small, analysis);
}

/// What the parts of a motion add up to, each with all of its value.
inline double total(const body::Motion& motion) {
  double sum = 0.0;
  for (const auto& part : motion.parts) sum += part.value;
  return sum;
}
inline body::Motion moved(double amplitude) { return {body::Drive::moved, {{amplitude, ""}}}; }
inline body::Motion loaded(double amplitude) { return {body::Drive::loaded, {{amplitude, ""}}}; }

/// Both directions of every node of an edge held.
inline body::Support fixed_edge(const std::string& name, const std::string& edge) {
  body::Support s;
  s.name = name;
  s.edge = edge;
  s.x.drive = s.y.drive = body::Drive::fixed;
  return s;
}

/// All load vectors of a body, in the order of its `loads()`.
inline std::vector<base::Vector> load_vectors(const mesh::Mesh& mesh, const body::BodyInput& input) {
  std::vector<base::Vector> f;
  for_each_load(input, [&](const auto& load) { f.push_back(fem::load_vector(mesh, input.analysis, load)); });
  return f;
}

struct LinearSolution {
  base::Vector q;
  base::Vector factors;  ///< all ones
};

inline const body::Motion& motion_of(const body::BodyInput& input, const body::SupportColumn& column) {
  const body::Support& s = input.supports[column.support];
  return column.motion == 0 ? s.x : column.motion == 1 ? s.y : s.rotation;
}

/// Solves one linear body without contact, all histories at factor one: r(q) = loads on the columns.
inline LinearSolution solve_linear(const body::LinearBody& b, const body::BodyInput& input) {
  LinearSolution s{base::Vector::Zero(b.dofs()), base::Vector::Ones(static_cast<int>(b.loads().size()))};
  base::Matrix K = b.tangent(s.q);
  std::vector<int> imposed;
  base::Vector force = base::Vector::Zero(b.dofs());
  for (const auto& c : b.support_columns()) {
    const body::Motion& m = motion_of(input, c);
    if (m.drive == body::Drive::loaded) force[c.column] += total(m);
    if (m.drive != body::Drive::fixed && m.drive != body::Drive::moved) continue;
    imposed.push_back(c.column);
    s.q[c.column] = m.drive == body::Drive::moved ? total(m) : 0.0;
  }
  base::Vector rhs = force - b.residual(s.q, s.factors);
  for (int column : imposed) {
    K.row(column).setZero();
    K.col(column).setZero();
    K(column, column) = 1.0;
    rhs[column] = 0.0;
  }
  if (b.dofs() > 0) s.q += algebra::solve_dense(K, rhs);
  return s;
}

struct NonlinearSolution {
  base::Vector q;
  body::Interior state;
  base::Vector factors;
  std::vector<double> table;  ///< of the last increment: unbalanced force over `force_scale`, per iteration
};

/// Solves one nonlinear body without contact by Newton, all histories rising to one in equal increments. Round-off
/// sets a limit to `tolerance`: bulk modulus over stress times that of a strain.
inline NonlinearSolution solve_nonlinear(const body::NonlinearBody& b, const body::BodyInput& input, int increments = 1,
                                         double tolerance = 1e-11) {
  NonlinearSolution s{base::Vector::Zero(b.dofs()), b.start(), {}, {}};
  body::NonlinearBody::Linearised lin;
  for (int k = 1; k <= increments; ++k) {
    const double factor = static_cast<double>(k) / increments;
    s.factors = base::Vector::Constant(static_cast<int>(b.loads().size()), factor);
    const body::Interior before = s.state;
    s.table.clear();
    for (int iteration = 0; iteration < 30; ++iteration) {
      b.linearise(before, s.state.y, s.q, s.factors, lin);
      base::Vector rhs = -lin.r;
      double off = 0.0;  // prescribed motion still to be made
      for (const auto& c : b.support_columns()) {
        const body::Motion& m = motion_of(input, c);
        if (m.drive == body::Drive::loaded) rhs[c.column] += factor * total(m);
        if (m.drive != body::Drive::fixed && m.drive != body::Drive::moved) continue;
        lin.S.row(c.column).setZero();
        lin.S(c.column, c.column) = lin.force_scale + 1.0;
        const double jump = (m.drive == body::Drive::moved ? factor * total(m) : 0.0) - s.q[c.column];
        rhs[c.column] = jump * lin.S(c.column, c.column);
        off = std::max(off, std::abs(jump));
      }
      const double unbalanced = std::max(lin.interior_residual, b.dofs() > 0 ? rhs.cwiseAbs().maxCoeff() : 0.0);
      s.table.push_back(unbalanced / (lin.force_scale + 1e-300));
      if (off == 0.0 && s.table.back() < tolerance) break;
      const base::Vector dq = b.dofs() > 0 ? algebra::solve_dense(lin.S, rhs) : rhs;
      s.state.y += b.interior_step(lin, dq);
      s.q += dq;
    }
    s.state = b.accepted(before, s.state.y, s.q);
  }
  return s;
}

}  // namespace reye::support
