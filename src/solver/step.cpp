#include "solver/increment.hpp"

/// Newton's step of an increment, by the matrix of the whole system or in compliance form.
namespace reye::solver {

/// Gives the window the rotations of the bodies that turn.
void Increment::turn_window(const System& system, const base::TwoPart& q) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b);
    const auto* turning = reduction().turning(body);
    if (!turning) continue;
    const auto own = reduction().of_body(body, q);
    const auto& load = loads_.turning[b];
    const double angle = turning->angle_of(own.high);
    Vector forces = Vector::Zero(own.size());
    if (turning->pivot[0] >= 0) {
      const Vector v = reduction().deformation(body, q), f = load.at(angle);
      for (int k : turning->pivot) forces[k] = reduction().stiffness(body).col(k).dot(v) - f[k];
    }
    window_.turn(body, own.high, forces, load.rate(angle));
  }
}

/// Where no support names the angle of a body, the frame turns with its chord.
void Increment::tie_angles(const System& system, const base::TwoPart& q) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const int body = static_cast<int>(b), at = reduction().first(body);
    const auto* turning = reduction().turning(body);
    if (!turning || turning->chord.empty()) continue;
    auto factors = turning->chord;
    for (auto& [column, factor] : factors) column = window_.index(at + column);
    condenser_.tie(window_.index(at + turning->angle), factors, -turning->chord_of(reduction().of_body(body, q).high));
  }
}

bool Increment::complies(const System& system) {
  return contacts_.limited() && contacts_.chosen() && compliance_.fits(system, reduction());
}

Vector Increment::step(const System& system, const Controls& controls, const base::TwoPart& q, StepMatrix matrix) {
  auto& faces = contacts_.faces();
  const bool chord = matrix == StepMatrix::kept;
  if (!chord) in_compliance_ = matrix == StepMatrix::compliance;
  if (in_compliance_) {
    if (!chord) compliance_.factor(controls, reduction(), faces, contacts_.nodes(), lambda_);
    return compliance_.solve(controls, reduction(), faces, -balance_, q, lambda_);
  }
  if (!chord) {
    const auto& derivatives = condenser_.linearise(faces, lambda_);
    window_.choose(system, reduction(), nonlinear_,
                   contacts_.limited() ? Reach::of_derivatives(faces, derivatives) : Reach::all(system));
  }
  if (!chord) turn_window(system, q);
  const Window::Load load = window_.load(-balance_);
  auto nodes = contacts_.nodes();
  for (auto& of_contact : nodes)
    for (auto& node : of_contact) {
      for (int t = 0; t < node.position.count; ++t)
        node.column[t] = node.column[t] < 0 ? -1 : window_.index(node.column[t]);
      if (node.angle >= 0) node.angle = window_.index(node.angle);
    }
  if (chord) {
    condenser_.again(load.inside);
  } else {
    condenser_.start(system, load.inside, faces, nodes);
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      const int body = static_cast<int>(b), at = reduction().first(body);
      if (const auto* rigid = std::get_if<body::RigidBody>(&system.bodies[b]))
        condenser_.add_body(window_.first(body),
                            rigid->tangent(q.high.segment(at, rigid->dofs()), controls.load_factors[b]));
      else
        condenser_.add_body(window_.first(body), window_.stiffness(body));
      if (reduction().turning(body))
        window_.add_turning(body, condenser_.tangent(window_.first(body), window_.stiffness(body).rows()));
    }
    for (const auto& spring : controls.springs)
      condenser_.stiffen(window_.index(reduction().index(spring.column)), spring.stiffness);
    for (std::size_t c = 0; c < faces.size(); ++c)
      condenser_.add_contact(system, static_cast<int>(c), faces[c], nodes[c], lambda_[c], reduction(), window_, q.high);
  }
  condenser_.eliminate(system, faces, nodes);
  for (const auto& [column, value] : controls.prescribed) {
    const int at = reduction().index(column);
    condenser_.fix(window_.index(at), value - q.high[at] - q.low[at]);
  }
  tie_angles(system, q);
  const Vector dq = condenser_.solve();
  for (std::size_t c = 0; c < faces.size(); ++c) condenser_.advance(static_cast<int>(c), dq, lambda_[c]);
  return window_.expand(dq.head(load.inside.size()), load);
}

}  // namespace reye::solver
