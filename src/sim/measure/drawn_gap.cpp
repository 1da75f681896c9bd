#include "sim/measure/drawn_gap.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/formatted.hpp"
#include "mesh/measure.hpp"
#include "scene/histories.hpp"
#include "sim/problem/drive.hpp"
#include "sim/problem/warnings.hpp"

namespace reye::sim {

namespace {

constexpr double at_once = 0.05;         ///< of the facet that a node lies behind: a smaller overlap is closed in one
                                         ///< increment, as facets of touching curves overlap by that
constexpr double drawn_together = 1e-4;  ///< of a facet: a smaller distance is rounding of the drawing
constexpr double facing = 0.1;           ///< cosine between two facets, as in the integrals
constexpr double other_surface =
    3.0;  ///< a node so many times nearer to the rest of the outline did not enter through this side
constexpr double deepest_fit = 1.0 / 3.0;  ///< of a body: the deepest overlap of a fit
constexpr int own_increments = 10;         ///< increments of the step that lets overlaps in before cycles

/// A piece of a side or an outline, body on the left.
struct Piece {
  Vec2 a, b;
  Vec2 along() const { return b - a; }
  double distance(const Vec2& x) const { return mesh::distance_to_edge(a, b, x); }
  bool faces(const Piece& other) const {
    return along().dot(other.along()) < -facing * along().norm() * other.along().norm();
  }
};

void append(std::vector<Piece>& pieces, const mesh::Mesh& mesh, const mesh::Chain& chain) {
  for (std::size_t i = 1; i < chain.size(); ++i) pieces.push_back({mesh.X[chain[i - 1]], mesh.X[chain[i]]});
}

/// The part of one side of a contact on one body.
struct Patch {
  std::vector<Piece> pieces, outline;
  Eigen::AlignedBox2d box;

  bool contains(const Vec2& x) const {
    if (!box.contains(x)) return false;
    bool inside = false;
    for (const auto& [a, b] : outline)
      if ((a.y() > x.y()) != (b.y() > x.y()) && x.x() < a.x() + (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y()))
        inside = !inside;
    return inside;
  }
};

Patch patch_of(const contact::BoundaryRef& ref, const std::vector<body::ShapePtr>& shapes) {
  const auto& mesh = shapes[ref.body]->mesh;
  Patch patch;
  for (const auto& chain : mesh.boundaries.at(ref.boundary)) append(patch.pieces, mesh, chain);
  for (const auto& loop : mesh.outline) append(patch.outline, mesh, loop);
  for (const Piece& piece : patch.outline) patch.box.extend(piece.a);
  return patch;
}

double nearest(const std::vector<Piece>& pieces, const Vec2& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces) least = std::min(least, piece.distance(x));
  return least;
}

/// The facet of a patch behind which a node x of a piece lies, were it inside; null: none faces it.
const Piece* facet_before(const Piece& piece, const Vec2& x, const Patch& other) {
  const Piece* behind = nullptr;
  for (const Piece& facet : other.pieces)
    if (piece.faces(facet) && (!behind || facet.distance(x) < behind->distance(x))) behind = &facet;
  return behind;
}

/// Compares a node x of a piece with the other patch.
void look_at(const Piece& piece, const Vec2& x, const Patch& other, DrawnGap& drawn) {
  if (const double gap = nearest(other.pieces, x); drawn.overlap_mm == 0.0 && gap < drawn.gap_mm) {
    drawn.gap_mm = gap > drawn_together * piece.along().norm() ? gap : 0.0;
    drawn.at = x;
  }
  const Piece* behind = other.contains(x) ? facet_before(piece, x, other) : nullptr;
  if (!behind) return;
  const double depth = behind->distance(x), facet = behind->along().norm();
  if (depth <= std::max(drawn.overlap_mm, drawn_together * facet) || depth > other_surface * nearest(other.outline, x))
    return;
  drawn = {0.0, depth, x, mesh::outward_normal(behind->a, behind->b), drawn.primary, depth > at_once * facet};
}

/// Compares the nodes of one patch with the other patch.
void look(const Patch& own, const Patch& other, DrawnGap& drawn) {
  for (const Piece& piece : own.pieces) {
    look_at(piece, piece.a, other, drawn);
    look_at(piece, piece.b, other, drawn);
  }
}

/// Extent of a body along a direction.
double extent(const mesh::Mesh& mesh, const Vec2& d) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2& X : mesh.X) {
    low = std::min(low, X.dot(d));
    high = std::max(high, X.dot(d));
  }
  return high - low;
}

/// Why an overlap is not a fit: a fit is shallow against both bodies along the way out.
std::string why_no_fit(const Problem& problem, const PlacedContact& contact) {
  const auto& drawn = contact.drawn;
  for (int body : {contact.secondary.body, drawn.primary}) {
    const double size = extent(problem.shapes[body]->mesh, drawn.out);
    if (drawn.overlap_mm > deepest_fit * size)
      return base::formatted(
          "its sides overlap by %.3g mm as drawn, at (%.4g, %.4g) mm, of the %.3g mm that body %s measures there: too "
          "deep "
          "for a fit; draw the bodies apart, or name the boundaries that touch",
          drawn.overlap_mm, drawn.at.x(), drawn.at.y(), size, problem.inputs[body].name.c_str());
  }
  return {};
}

/// Adds the history of the remaining overlap to the first step, or to an extra step before it.
void add_to_steps(scene::Scene& scene) {
  if (!scene.histories.emplace(overlap_left, scene::History{{0.0, 1.0}, {1.0, 0.0}}).second)
    return;  // a companion run's scene
  if (scene.steps.front().cycles > 0.0) {
    scene::Step step;
    step.name = overlap_left;
    step.increments = own_increments;
    step.wear = false;
    scene.steps.insert(scene.steps.begin(), step);
  }
  scene.steps.front().play.push_back(overlap_left);
}

bool driven_by_force(const body::BodyInput& input) {
  const auto pushes = [](const body::Motion& m) { return m.drive == body::Drive::loaded && !m.parts.empty(); };
  const auto loaded = [&](const body::Support& s) { return pushes(s.x) || pushes(s.y) || pushes(s.rotation); };
  return !input.boundary_loads.empty() || !input.point_loads.empty() || !input.body_forces.empty() ||
         std::any_of(input.supports.begin(), input.supports.end(), loaded);
}

/// Whether the motions and forces of the bodies may close the drawn gap.
bool closes(const Problem& problem, const PlacedContact& contact) {
  const auto by_force = [&](const contact::BoundaryRef& ref) { return driven_by_force(problem.inputs[ref.body]); };
  return by_force(contact.secondary) || std::any_of(contact.primary.begin(), contact.primary.end(), by_force) ||
         farthest_way(problem, contact) >= contact.drawn.gap_mm;
}

/// The largest motion of any support; infinite where a force drives a body.
double farthest_way_of_all(const Problem& problem) {
  double way = 0.0;
  for (const auto& input : problem.inputs) {
    if (driven_by_force(input)) return std::numeric_limits<double>::infinity();
    for (const auto& support : input.supports)
      for (const auto* motion : {&support.x, &support.y, &support.rotation})
        if (motion->drive == body::Drive::moved)
          way = motion == &support.rotation ? std::numeric_limits<double>::infinity()
                                            : std::max(way, scene::largest_value(problem.scene, motion->parts));
  }
  return way;
}

}  // namespace

DrawnGap drawn_gap(const PlacedContact& contact, const std::vector<body::ShapePtr>& shapes) {
  DrawnGap drawn;
  drawn.gap_mm = std::numeric_limits<double>::infinity();
  const Patch secondary = patch_of(contact.secondary, shapes);
  for (const auto& ref : contact.primary) {
    const Patch primary = patch_of(ref, shapes);
    const double before = drawn.overlap_mm;
    look(secondary, primary, drawn);
    look(primary, secondary, drawn);
    if (drawn.overlap_mm > before) drawn.primary = ref.body;
  }
  return drawn;
}

double farthest_way(const Problem& problem, const PlacedContact& contact) {
  double way = 0.0;
  const auto look_at = [&](int body) {
    for (const auto& support : problem.inputs[body].supports)
      for (const auto* motion : {&support.x, &support.y})
        if (motion->drive == body::Drive::moved)
          way = std::max(way, scene::largest_value(problem.scene, motion->parts));
  };
  look_at(contact.secondary.body);
  for (const auto& ref : contact.primary) look_at(ref.body);
  return way;
}

void warn_of_gap(Problem& problem, const PlacedContact& contact) {
  const double way = farthest_way_of_all(problem);
  if (contact.drawn.gap_mm <= way) return;
  warn(problem.warnings, {"gap", "contact " + contact.options.name,
                          base::formatted("Its sides are %.4g mm apart as drawn, and supports move no body by more "
                                          "than %.4g mm, nor does a force: they never "
                                          "touch. Draw them closer, or move them farther.",
                                          contact.drawn.gap_mm, way)});
}

std::vector<base::Issue> place_drawn_gaps(Problem& problem) {
  std::vector<base::Issue> issues;
  bool let_in = false;
  for (auto& contact : problem.contacts) {
    auto [options, drawn] = std::tie(contact.options, contact.drawn);
    drawn = drawn_gap(contact, problem.shapes);
    if (closes(problem, contact)) options.drawn_mm = drawn.gap_mm;
    let_in = let_in || drawn.let_in;
    warn_of_gap(problem, contact);
    if (const auto why = why_no_fit(problem, contact); !why.empty())
      issues.push_back({"contact." + options.name, "", why});
  }
  if (let_in) add_to_steps(problem.scene);
  return issues;
}

std::string why_out_of_reach(const Problem& problem, const PlacedContact& contact, double search_mm) {
  if (contact.drawn.gap_mm <= search_mm) return ": they do not face each other; name boundaries that do";
  std::string why = base::formatted("; the sides are %.4g mm apart as drawn", contact.drawn.gap_mm);
  if (!closes(problem, contact))
    return why + base::formatted(
                     ", and supports move these bodies by %.4g mm at most: draw them closer, or move them farther",
                     farthest_way(problem, contact));
  return why + (contact.options.search_mm > 0.0 ? ": leave search_mm out" : "");
}

std::string in_words(const Problem& problem, const PlacedContact& contact) {
  const auto& drawn = contact.drawn;
  const std::string about = "contact " + contact.options.name + ": ";
  if (drawn.overlap_mm == 0.0 && drawn.gap_mm == 0.0)
    return about +
           base::formatted("its sides touch as drawn, at (%.6g, %.6g) mm", drawn.at.x() + 0.0, drawn.at.y() + 0.0);
  const bool overlaps = drawn.overlap_mm > 0.0;
  const std::string size =
      about + base::formatted("drawn %s of %.3g mm, at (%.6g, %.6g) mm", overlaps ? "overlap" : "gap",
                              overlaps ? drawn.overlap_mm : drawn.gap_mm, drawn.at.x() + 0.0, drawn.at.y() + 0.0);
  if (!overlaps) return size;
  if (!drawn.let_in) return size + ", closed at once: it is less than a twentieth of a facet";
  const auto& step = problem.scene.steps.front();
  return size + base::formatted(", let in over the %d increment%s of step \"%s\"", step.increments,
                                step.increments == 1 ? "" : "s", step.name.c_str());
}

}  // namespace reye::sim
