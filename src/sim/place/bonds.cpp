#include "sim/place/bonds.hpp"

#include <algorithm>

#include "base/formatted.hpp"
#include "body/turning.hpp"
#include "contact/interface.hpp"

namespace reye::sim {

namespace {

/// Share of a facet; facets of coincident curves differ by less where six of them make a quarter turn.
constexpr double apart = 0.1;

/// How the sides of a bond lie on the drawing.
struct BondFit {
  bool bonded = false;  ///< somewhere
  int worst = -1;       ///< the node farthest from the other side of those too far from it; -1: there is none
  double distance = 0.0;
};

BondFit fit_of(const contact::Setup& setup) {
  contact::Interface face;
  const auto fresh = contact::fresh_state(setup);
  face.begin(setup, fresh, setup.secondary.X, setup.primary.X, {});
  face.integrate(setup.secondary.X, setup.primary.X);
  BondFit fit;
  for (int j = 0; j < setup.secondary_count(); ++j) {
    if (setup.cut[j] || !face.touching(j)) continue;
    fit.bonded = true;
    const double distance = std::abs(face.gap()[j]) / face.rows()[j].D;
    if (distance <= apart * setup.length[j] || distance <= fit.distance) continue;
    fit.distance = distance;
    fit.worst = j;
  }
  return fit;
}

std::string why_unbonded(const contact::Setup& setup) {
  const BondFit fit = fit_of(setup);
  if (!fit.bonded) return "no facet of the secondary side lies on a primary one";
  if (fit.worst < 0) return {};
  const Vec2& x = setup.secondary.X[fit.worst];
  return base::formatted(
      "its sides are %.3g mm apart at (%.4g, %.4g) mm, where facets are %.3g mm long; a bond joins what "
      "lies on one another: draw the sides so, or make it a contact",
      fit.distance, x.x(), x.y(), setup.length[fit.worst]);
}

bool keeps_direction(const Problem& p, int b) {
  return !p.rigid[b] && !is_nonlinear(p.inputs[b]) && !body::pivot_of(p.shapes[b]->mesh, p.inputs[b]);
}

}  // namespace

void keep_directions(Problem& problem) {
  const auto spread = [&](int from, int to) {
    if (!keeps_direction(problem, from) || problem.rigid[to] || is_nonlinear(problem.inputs[to])) return false;
    const auto pivot = body::pivot_of(problem.shapes[to]->mesh, problem.inputs[to]);
    if (!pivot || pivot->support >= 0) return false;
    return problem.inputs[to].keeps_direction = true;
  };
  for (bool more = true; more;) {
    more = false;
    for (const auto& bond : problem.bonds)
      for (const auto& ref : bond.primary)
        more = spread(bond.secondary.body, ref.body) || spread(ref.body, bond.secondary.body) || more;
  }
}

std::vector<base::Issue> bond_issues(const Problem& problem, const solver::System& system) {
  std::vector<base::Issue> issues;
  for (std::size_t b = 0; b < problem.bonds.size(); ++b) {
    const auto why = why_unbonded(system.contacts[problem.contacts.size() + b]);
    if (!why.empty()) issues.push_back({"bond." + problem.bonds[b].options.name, "", why});
  }
  return issues;
}

}  // namespace reye::sim
