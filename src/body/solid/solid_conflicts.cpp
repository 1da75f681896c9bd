#include "body/solid/solid_conflicts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "algebra/decompose.hpp"
#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "body/columns.hpp"
#include "body/imposed.hpp"
#include "body/solid/rigid_modes.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

std::string spot(const Vec3& X) { return base::formatted("(%.4g, %.4g, %.4g)", X.x() + 0.0, X.y() + 0.0, X.z() + 0.0); }

Imposed imposed_value(const Motion& motion) {
  Imposed value;
  add(value, motion, 1.0);
  return value;
}

double largest_of(const Imposed& value) {
  double largest = 0.0;
  for (const auto& [history, amplitude] : value) largest = std::max(largest, std::abs(amplitude));
  return largest;
}

/// A sum of imposed values, and the sum of their sizes.
struct Expected {
  Imposed value;
  double size = 0.0;

  void add_motion(const Motion& motion, double weight) {
    add(value, motion, weight);
    size += std::abs(weight) * largest_of(imposed_value(motion));
  }
};

/// What a rigid face prescribes to a node along a direction.
struct FaceValue {
  Expected value;
  std::optional<int> undetermined;  ///< a free or loaded motion of the face that moves the node along it
};

class SolidConflicts {
 public:
  explicit SolidConflicts(const SolidInput& input) : input_(input) {
    for (const auto& support : input.supports) places_.push_back(place_support(*input.mesh, support));
    for (int s = 0; s < static_cast<int>(places_.size()); ++s) check_kind(s);
    if (input.rigid)
      check_rigid_body();
    else
      for (const auto& [node, demands] : node_demands(input, places_)) check_node(node, demands);
  }

  std::vector<SupportConflict> found;

 private:
  const SolidSupport& support(int s) const { return input_.supports[s]; }
  std::string named(int s) const { return "support " + base::quoted(support(s).name); }

  /// One conflict per pair of supports; a refusal takes the place of a warning.
  void note(int s, int other, const std::string& motion, const std::string& text, bool refused = true) {
    const auto [place, fresh] = pairs_.try_emplace({s, other}, found.size());
    SupportConflict conflict{s, motion, text, refused};
    if (fresh)
      found.push_back(std::move(conflict));
    else if (refused && !found[place->second].refused)
      found[place->second] = std::move(conflict);
  }

  void check_kind(int s) {
    for (int m = 0; m <= normal_motion; ++m) {
      const Motion& motion = motion_of(support(s), m);
      const std::string name = solid_motion_names[m];
      if (motion.drive == Drive::free) continue;
      if (support(s).rigid && m == normal_motion)
        note(s, -1 - m, name, "a rigid face has no motion along its normal; name its axes instead");
      if (!support(s).rigid && m >= 3 && m < normal_motion)
        note(s, -1 - m, name, "a face turns only where it is rigid");
      if (!support(s).rigid && motion.drive == Drive::loaded)
        note(s, -1 - m, name, "a face held node by node cannot be loaded; make it rigid, or name a load on the face");
    }
  }

  void check_node(int node, const NodeDemands& demands) {
    const auto all_fixed = [&](int s) {
      for (int m = 0; m < 6; ++m)
        if (motion_of(support(s), m).drive != Drive::fixed) return false;
      return true;
    };
    for (size_t k = 1; k < demands.rigid.size(); ++k)
      if (!all_fixed(demands.rigid.front()) || !all_fixed(demands.rigid[k]))
        note(demands.rigid[k], demands.rigid.front(), "",
             "shares the node at " + spot(input_.mesh->X[node]) + " with " + named(demands.rigid.front()) +
                 ", and both are rigid faces; name what moves as one in one face, and say in one support how it moves");
    if (!demands.rigid.empty())
      for (const auto& demand : demands.by_node) check_on_face(node, demand, demands.rigid.front());
    else
      check_by_node(node, demands.by_node);
  }

  /// Independent directions of a node stand; every other must follow from them.
  void check_by_node(int node, const std::vector<SolidDemand>& demands) {
    const std::vector<int> standing = independent(demands);
    Matrix d(3, static_cast<Eigen::Index>(standing.size()));
    for (size_t k = 0; k < standing.size(); ++k) d.col(static_cast<Eigen::Index>(k)) = demands[standing[k]].direction;
    for (int j = 0; j < static_cast<int>(demands.size()); ++j) {
      if (std::find(standing.begin(), standing.end(), j) != standing.end()) continue;
      const auto& [s, m, direction] = demands[j];
      const Vector share = dual_directions(d).transpose() * direction;
      Expected expected;
      int other = -1;
      for (size_t k = 0; k < standing.size(); ++k) {
        const auto& stands = demands[standing[k]];
        if (standing[k] > j || std::abs(share[static_cast<Eigen::Index>(k)]) < parallel) continue;
        expected.add_motion(motion_of(support(stands.support), stands.motion), share[static_cast<Eigen::Index>(k)]);
        other = stands.support;
      }
      if (!agree_nearly(expected, motion_of(support(s), m)))
        note(s, other, solid_motion_names[m],
             "asks of the node at " + spot(input_.mesh->X[node]) + " another motion than " + named(other) +
                 " does; a place can be held or moved along a direction once");
    }
  }

  /// Directions count as one up to an angle: so do values, by the sizes of what they are made of.
  static bool agree_nearly(const Expected& expected, const Motion& own) {
    const Imposed value = imposed_value(own);
    double difference = 0.0;
    Imposed rest = expected.value;
    add(rest, value, -1.0);
    for (const auto& [history, amplitude] : rest) difference = std::max(difference, std::abs(amplitude));
    return difference <= 2.0 * parallel * (expected.size + largest_of(value));
  }

  FaceValue along(const SolidDemand& demand, int node, int face) const {
    const Vec3& c = places_[face].centre;
    double length = 0.0;
    for (int other : places_[face].nodes) length = std::max(length, (input_.mesh->X[other] - c).norm());
    FaceValue result;
    for (int m = 0; m < 6; ++m) {
      const double weight =
          demand.direction.dot(modes_at(input_.mesh->X[node], c) * row_of(support(face), face, m, c, c).row);
      if (std::abs(weight) <= parallel * (m < 3 ? 1.0 : length)) continue;
      const Motion& motion = motion_of(support(face), m);
      if (motion.drive == Drive::free || motion.drive == Drive::loaded) {
        result.undetermined = m;
        if (motion.drive == Drive::loaded) return result;
      }
      result.value.add_motion(motion, weight);
    }
    return result;
  }

  /// A node of a rigid face moves with it wholly: another support may only prescribe what the face does.
  void check_on_face(int node, const SolidDemand& demand, int face) {
    const auto& [s, m, direction] = demand;
    const FaceValue face_value = along(demand, node, face);
    if (!face_value.undetermined && agree_nearly(face_value.value, motion_of(support(s), m))) return;
    const int free = face_value.undetermined.value_or(-1);
    const bool pushed = free >= 0 && motion_of(support(face), free).drive == Drive::loaded;
    const bool nothing_left = std::includes(places_[face].nodes.begin(), places_[face].nodes.end(),
                                            places_[s].nodes.begin(), places_[s].nodes.end());
    note(s, face, solid_motion_names[m],
         "the node at " + spot(input_.mesh->X[node]) + " moves with the rigid face of " + named(face) +
             (free < 0 ? ""
                       : std::string(", whose ") + solid_motion_names[free] + " is " + (pushed ? "loaded" : "free")) +
             ", and not as " + named(s) + " asks; say it in the support of the rigid face",
         free < 0 || pushed || nothing_left);
  }

  /// All forms of the body's six motions that supports drive, in turn: what follows from those before must agree.
  void check_rigid_body() {
    const Vec3 c = mesh::box_centre(input_.mesh->X);
    Mode scale = Mode::Ones();
    scale.tail<3>().setConstant(1.0 / mesh::box_diagonal(input_.mesh->X));
    Matrix basis(6, 0), standing(6, 0);
    std::vector<ModeRow> rows;
    for (const auto& row : driven_rows(c)) {
      const Mode form = row.row.cwiseProduct(scale);
      const Vector rest = form - basis * (basis.transpose() * form);
      if (rest.norm() < 1e-6) {
        check_dependent(row, form, standing, rows);
        continue;
      }
      basis.conservativeResize(6, basis.cols() + 1);
      basis.rightCols<1>() = rest.normalized();
      standing.conservativeResize(6, standing.cols() + 1);
      standing.rightCols<1>() = form;
      rows.push_back(row);
    }
  }

  std::vector<ModeRow> driven_rows(const Vec3& c) const {
    std::vector<ModeRow> rows = held_rows(input_, places_, c, false);
    for (int s = 0; s < static_cast<int>(places_.size()); ++s)
      for (int m = 0; m < 6 && support(s).rigid; ++m)
        if (motion_of(support(s), m).drive == Drive::loaded)
          rows.push_back(row_of(support(s), s, m, places_[s].centre, c));
    return rows;
  }

  void check_dependent(const ModeRow& row, const Mode& form, const Matrix& standing, const std::vector<ModeRow>& rows) {
    const Vector share = algebra::least_squares(standing, form);
    const Motion& own = motion_of(support(row.support), row.motion);
    Expected expected;
    int other = -1;
    bool loaded = own.drive == Drive::loaded;
    for (size_t k = 0; k < rows.size(); ++k) {
      const double weight = share[static_cast<Eigen::Index>(k)];
      if (std::abs(weight) < 1e-6) continue;
      const Motion& motion = motion_of(support(rows[k].support), rows[k].motion);
      loaded = loaded || motion.drive == Drive::loaded;
      expected.add_motion(motion, weight);
      if (other < 0 || rows[k].support != row.support) other = rows[k].support;
    }
    if (!loaded && agree_nearly(expected, own)) return;
    note(row.support, other, solid_motion_names[row.motion],
         "drives the rigid body as " + (other == row.support ? "another of its motions" : named(other)) +
             " does already; a motion of a rigid body can be held, moved or loaded once");
  }

  const SolidInput& input_;
  std::vector<SolidPlace> places_;
  std::map<std::pair<int, int>, size_t> pairs_;
};

}  // namespace

std::vector<SupportConflict> solid_support_conflicts(const SolidInput& input) {
  if (auto issues = place_issues(input); !issues.empty()) throw base::InputError(std::move(issues));
  return SolidConflicts(input).found;
}

}  // namespace reye::body
