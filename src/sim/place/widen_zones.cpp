#include "sim/place/widen_zones.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/formatted.hpp"
#include "body/turning.hpp"
#include "cad/build/turned_zone.hpp"
#include "scene/histories.hpp"
#include "sim/measure/zones.hpp"

namespace reye::sim {

namespace {

constexpr double most_nodes = 1500.0;  ///< on one zone: twice as many columns are retained, a dense matrix of 70 MB

/// The least and the largest value that a motion takes.
std::array<double, 2> range_of(const scene::Scene& scene, const body::Motion& motion) {
  return motion.drive == body::Drive::moved ? scene::range_of(scene, motion.parts) : std::array{0.0, 0.0};
}

double length(const std::array<double, 2>& range) { return range[1] - range[0]; }

/// The largest motion by a support at x, of all bodies but one.
double longest_way(const Problem& p, int body, const Vec2& x) {
  double way = 0.0;
  for (int b = 0; b < p.body_count(); ++b)
    for (const auto& support : p.inputs[b].supports) {
      way = std::max({way, length(range_of(p.scene, support.x)), length(range_of(p.scene, support.y))});
      if (b == body) continue;
      const auto pivot = body::pivot_of(p.shapes[b]->mesh, p.inputs[b]);
      if (pivot) way = std::max(way, length(range_of(p.scene, support.rotation)) * (x - pivot->centre).norm());
    }
  return way;
}

cad::FineZone widened(const Problem& p, int b, const body::Pivot& pivot, const cad::Part& part,
                      const cad::FineZone& zone) {
  cad::Turn turn{pivot.centre};
  if (pivot.names_angle) {
    const auto range = range_of(p.scene, p.inputs[b].supports[pivot.support].rotation);
    turn.least = pivot.hand > 0.0 ? range[0] : -range[1];
    turn.most = pivot.hand > 0.0 ? range[1] : -range[0];
  }
  if (length({turn.least, turn.most}) == 0.0) {
    turn.most = longest_way(p, b, zone.centre_mm) / (zone.centre_mm - pivot.centre).norm();
    turn.least = -turn.most;
  }
  return cad::turned_zone(part, zone, turn, most_nodes);
}

}  // namespace

void widen_zones(Problem& p) {
  for (int b = 0; b < p.body_count(); ++b) {
    const auto& shape = *p.shapes[b];
    if (!shape.drawing || shape.drawing->part.mesh || shape.drawing->zones.empty()) continue;
    const auto pivot = body::pivot_of(shape.mesh, p.inputs[b]);
    if (!pivot) continue;
    cad::Drawing drawing = *shape.drawing;
    for (auto& zone : drawing.zones) zone = widened(p, b, *pivot, drawing.part, zone);
    if (std::none_of(drawing.zones.begin(), drawing.zones.end(), [](const auto& zone) { return zone.turns; })) continue;
    try {
      mesh::Mesh mesh = cad::remesh(drawing);
      cad::choose_arc_origins(mesh, drawing);
      p.shapes[b] = body::make_shape(std::move(mesh), std::make_shared<const cad::Drawing>(std::move(drawing)));
    } catch (const base::MeshError& error) {
      throw base::MeshError("body " + p.inputs[b].name + ", with a fine zone as wide as it turns: " + error.what());
    }
  }
}

std::vector<std::string> widened_zones(const Problem& p, int body) {
  std::vector<std::string> lines;
  if (!p.shapes[body]->drawing) return lines;
  for (const auto& zone : p.shapes[body]->drawing->zones) {
    const auto* asked = asked_for(p, zone);
    if (!zone.turns || !asked) continue;
    lines.push_back(base::formatted(
        "  fine zone of contact %s round (%.4g, %.4g): as far as the body turns under it, elements of %.3g mm",
        zone.contact.c_str(), asked->centre_mm.x() + 0.0, asked->centre_mm.y() + 0.0, zone.size_mm));
    if (zone.size_mm <= asked->size_mm) continue;
    lines.back() +=
        base::formatted(" instead of %.3g mm, so that no more than %g nodes are retained", asked->size_mm, most_nodes);
  }
  return lines;
}

}  // namespace reye::sim
