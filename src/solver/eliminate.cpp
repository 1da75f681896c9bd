#include <utility>

#include "solver/condense.hpp"

/// Eliminates the multipliers of active nodes from Newton's matrix.   [README (2)]
namespace reye::solver {

/// Columns of slope for the components of dlambda of active nodes.
void Condenser::place(const std::vector<contact::Interface>& faces) {
  for (std::size_t c = 0; c < faces.size(); ++c) {
    auto& elim = elimination_[c];
    const int ns = faces[c].setup().secondary_count();
    elim.place.assign(ns, -1);
    elim.held.assign(ns, -1);
    int count = 0;
    for (int j = 0; j < ns; ++j)
      if (faces[c].active(j)) {
        elim.place[j] = count;
        count += 2;
      }
    elim.slope.setZero(At_.rows(), count);
  }
}

/// Turns of all active nodes, contact by contact, those first that load the balance of others.
void Condenser::arrange(const System& system, const std::vector<contact::Interface>& faces,
                        const std::vector<std::vector<PlacedNode>>& nodes) {
  std::vector<Turn> all;
  std::vector<int> of_column(static_cast<std::size_t>(At_.rows()), -1);
  for (int c : system.elimination)
    for (int j = 0; j < faces[c].setup().secondary_count(); ++j) {
      if (elimination_[c].place[j] < 0) continue;
      const auto& node = nodes[c][j];
      for (int t = node.position.count - node.free; t < node.position.count; ++t)
        of_column[node.column[t]] = static_cast<int>(all.size());
      all.push_back({c, j, {}, {}});
    }
  std::vector<std::vector<int>> loaded_by(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto& of_contact = nodes[all[k].contact];
    for (const auto& [beside, share] : faces[all[k].contact].rows()[all[k].node].off)
      for (int t = 0; t < of_contact[beside].position.count; ++t)
        if (const int other = of_column[of_contact[beside].column[t]]; other >= 0)
          loaded_by[other].push_back(static_cast<int>(k));
  }
  turns_.clear();
  std::vector<char> met(all.size(), 0);
  const auto add = [&](auto&& self, int k) -> void {
    if (std::exchange(met[k], 1)) return;
    for (int first : loaded_by[k]) self(self, first);
    turns_.push_back(std::move(all[k]));
  };
  for (std::size_t k = 0; k < met.size(); ++k) add(add, static_cast<int>(k));
}

/// dlambda = constant + slope dq from the balance of an active node; along a held direction an unknown.
void Condenser::express(const contact::Interface& face, const PlacedNode& node, Turn& turn) {
  auto& elim = elimination_[turn.contact];
  const int j = turn.node, place = elim.place[j];
  const double D = face.rows()[j].D;
  const auto& p = node.position;
  for (int t = p.count - node.free; t < p.count; ++t)
    for (int c = 0; c < 2; ++c) {
      const double share = p.terms[t].direction[c] / D;
      if (share == 0.0) continue;
      elim.slope.col(place + c) -= share * At_.col(node.column[t]);
      turn.from.push_back({node.column[t], place + c, share});
    }
  if (node.free == 2) return;
  elim.held[j] = next_held_++;
  const Vec2& free = p.terms[p.count - 1].direction;
  elim.slope(elim.held[j], place) = -free.y() * face.setup().stiffness[j];
  elim.slope(elim.held[j], place + 1) = free.x() * face.setup().stiffness[j];
}

/// Adds factor * dlambda to the rows of a node.
void Condenser::load(const PlacedNode& node, Turn& turn, double factor) {
  const auto& elim = elimination_[turn.contact];
  const int from = elim.place[turn.node];
  for (int t = 0; t < node.position.count; ++t)
    for (int c = 0; c < 2; ++c) {
      const double weight = factor * node.position.terms[t].direction[c];
      if (weight == 0.0) continue;
      At_.col(node.column[t]) += weight * elim.slope.col(from + c);
      turn.to.push_back({node.column[t], from + c, weight});
    }
}

void Condenser::eliminate(const System& system, const std::vector<contact::Interface>& faces,
                          const std::vector<std::vector<PlacedNode>>& nodes) {
  if (!factored_) {
    place(faces);
    arrange(system, faces, nodes);
    for (auto& turn : turns_) {
      const auto& face = faces[turn.contact];
      const auto& of_contact = nodes[turn.contact];
      express(face, of_contact[turn.node], turn);
      const auto& row = face.rows()[turn.node];
      for (const auto& [k, share] : row.off) load(of_contact[k], turn, share);
      for (const auto& [l, M] : row.M) load(of_contact[face.setup().secondary_count() + l], turn, -M);
    }
    for (int c : system.elimination) conditions(faces[c], nodes[c], elimination_[c], linearised_[c]);
  }
  right_hand_side(system, faces);
}

/// Conditions replace the rows of a node's free columns, and give held multipliers theirs, scaled to the stiffness of
/// their surroundings.
void Condenser::conditions(const contact::Interface& face, const std::vector<PlacedNode>& nodes, Elimination& elim,
                           const contact::Linearised& linearised) {
  const auto ns = elim.place.size();
  std::vector<int> of_row(2 * ns, -1);
  elim.conditions.clear();
  for (std::size_t j = 0; j < ns; ++j) {
    if (elim.place[j] < 0) continue;
    const int first = nodes[j].position.count - nodes[j].free;
    const bool traction = face.shear_is_given(static_cast<int>(j));
    for (int t = 0; t < 2; ++t) {
      const int row = 2 * static_cast<int>(j) + t;
      of_row[row] = static_cast<int>(elim.conditions.size());
      const double scale = t == 1 && traction ? face.rows()[j].D : face.setup().stiffness[j];
      elim.conditions.push_back({t < nodes[j].free ? nodes[j].column[first + t] : elim.held[j], row, scale});
      At_.col(elim.conditions.back().column).setZero();
    }
  }
  const int multipliers = face.dofs();
  weight_.setZero(elim.slope.cols(), static_cast<Eigen::Index>(elim.conditions.size()));
  elim.met.clear();
  for (const auto& e : linearised.rows) {
    const int k = of_row[e.row];
    if (k < 0) continue;
    const auto& condition = elim.conditions[k];
    const double value = condition.scale * e.value;
    if (e.col >= multipliers) {
      const int component = elim.place[(e.col - multipliers) / 2] + (e.col - multipliers) % 2;
      double& weight = weight_(component, k);
      if (weight == 0.0) elim.met.push_back({k, component, 0.0});
      weight += value;
      continue;
    }
    const auto& node = nodes[e.col / 2];
    for (int t = 0; t < node.position.count; ++t)
      At_(inside(node.column[t]), condition.column) += value * node.position.terms[t].direction[e.col % 2];
    if (node.angle >= 0) At_(node.angle, condition.column) += value * node.position.swing[e.col % 2];
  }
  for (auto& s : elim.met) {  // a weight that passed through zero is listed twice, and counts once
    s.factor = std::exchange(weight_(s.component, s.column), 0.0);
    s.column = elim.conditions[s.column].column;
    At_.col(s.column) += s.factor * elim.slope.col(s.component);
  }
}

/// The right-hand side after elimination.
void Condenser::right_hand_side(const System& system, const std::vector<contact::Interface>& faces) {
  for (auto& elim : elimination_) elim.constant.setZero(elim.slope.cols());
  for (const auto& turn : turns_) {
    auto& constant = elimination_[turn.contact].constant;
    for (const auto& s : turn.from) constant[s.component] += s.factor * b_[s.column];
    for (const auto& s : turn.to) b_[s.column] -= s.factor * constant[s.component];
  }
  for (int contact : system.elimination) {
    const auto& face = faces[contact];
    const auto& elim = elimination_[contact];
    for (const auto& c : elim.conditions)
      b_[c.column] =
          -c.scale * (c.row % 2 == 0 ? face.residual_normal(c.row / 2) : face.residual_tangential(c.row / 2));
    for (const auto& s : elim.met) b_[s.column] -= s.factor * elim.constant[s.component];
  }
}

}  // namespace reye::solver
