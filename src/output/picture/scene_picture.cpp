#include "output/picture/scene_picture.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "base/formatted.hpp"
#include "mesh/measure.hpp"
#include "output/folder/text.hpp"
#include "output/picture/actions.hpp"
#include "output/picture/canvas.hpp"
#include "output/picture/key_pieces.hpp"

namespace reye::output {

namespace {

constexpr double gutter = 60.0, panel_height = 380.0, line_height = 19.0;
constexpr const char *secondary_colour = "#c8502d", *primary_colour = "#1f5fa8", *bond_colour = "#2f8f5b",
                     *zone_colour = "#6a717c";
constexpr std::array fills{"#e8eef5", "#f5efe3", "#e6f1ea", "#f1e8f2", "#eeeeee"};

Points points_of(const mesh::Mesh& mesh, const mesh::Chain& chain) {
  Points x;
  for (const int node : chain) x.push_back(mesh.X[node]);
  return x;
}

/// The edges between the elements that are seen; none where they would be a grey field. Two cells run along an edge in
/// opposite directions; edges of the outline are drawn with it.
void draw_mesh(const mesh::Mesh& mesh, Canvas& canvas) {
  constexpr std::size_t most = 5000;
  constexpr double least_pixels = 3.0;
  std::vector<std::pair<Vec2, Vec2>> edges;
  double length = 0.0;
  const int n = mesh::corners(mesh.kind);
  for (const auto& cell : mesh.cells)
    for (int k = 0; k < n; ++k) {
      const int from = cell[k], to = cell[(k + 1) % n];
      const Vec2 &a = mesh.X[from], &b = mesh.X[to];
      if (from > to || (!canvas.seen().holds(a) && !canvas.seen().holds(b))) continue;
      if (edges.size() == most) return;
      edges.emplace_back(a, b);
      length += (a - b).norm();
    }
  if (length * canvas.pixels_per_mm() < least_pixels * static_cast<double>(edges.size())) return;
  if (!edges.empty()) canvas.edges(edges, "#b9c1ca", 0.6);
}

void draw_boundary(const sim::Problem& p, int body, const std::string& name, const char* colour, double thick,
                   Canvas& canvas) {
  const auto& mesh = p.shapes[body]->mesh;
  const auto found = mesh.boundaries.find(name);
  if (found == mesh.boundaries.end()) return;
  for (const auto& chain : found->second) canvas.line(points_of(mesh, chain), colour, thick);
}

void draw_joint(const sim::Problem& p, const sim::PlacedContact& joint, bool bond, Canvas& canvas) {
  for (const auto& ref : joint.primary)
    draw_boundary(p, ref.body, ref.boundary, bond ? bond_colour : primary_colour, 5.0, canvas);
  // Narrower, so that both sides are seen where they lie on one another.
  draw_boundary(p, joint.secondary.body, joint.secondary.boundary, bond ? bond_colour : secondary_colour, 2.2, canvas);
}

Points corners_of(const cad::FineZone& zone) {
  const double angle = zone.angle_deg * std::numbers::pi / 180.0;
  const Vec2 along = zone.half_width_mm * Vec2(std::cos(angle), std::sin(angle)),
             across = zone.depth_mm * Vec2(-std::sin(angle), std::cos(angle));
  const Vec2& c = zone.centre_mm;
  return {c - along - across, c + along - across, c + along + across, c - along + across, c - along - across};
}

std::string gap_in_words(const sim::DrawnGap& drawn) {
  const auto size = [](double mm) {
    return mm < 0.1 ? base::formatted("%.3g µm", 1e3 * mm) : base::formatted("%.4g mm", mm);
  };
  if (drawn.overlap_mm > 0.0) return "overlap " + size(drawn.overlap_mm);
  return drawn.gap_mm > 0.0 ? "gap " + size(drawn.gap_mm) : "touches";
}

/// Everything in one field: the whole scene with letters, or one contact.
void draw(const sim::Problem& p, const std::vector<Action>& actions, const sim::PlacedContact* one, Canvas& canvas) {
  const auto shows_gap = [one](const sim::PlacedContact& contact) {
    return one ? one == &contact : contact.drawn.gap_mm > 0.0 || contact.drawn.overlap_mm > 0.0;
  };
  for (int b = 0; b < p.body_count(); ++b) {
    const auto& mesh = p.shapes[b]->mesh;
    std::vector<Points> loops;
    for (const auto& chain : mesh.outline) loops.push_back(points_of(mesh, chain));
    canvas.area(loops, p.rigid[b] ? "#cfd4da" : fills[static_cast<std::size_t>(b) % fills.size()]);
    draw_mesh(mesh, canvas);
  }
  for (const auto& zone : p.scene.geometry.fine_zones) canvas.line(corners_of(zone), zone_colour, 1.0, "5 3");
  for (const auto& action : actions) draw_boundary(p, action.body, action.edge, action.colour, 2.4, canvas);
  for (const auto& bond : p.bonds) draw_joint(p, bond, true, canvas);
  for (const auto& contact : p.contacts) draw_joint(p, contact, false, canvas);
  if (!one)
    for (const auto& action : actions) {
      for (const auto& [direction, both] : action.arrows)
        canvas.arrow(action.at, 34.0 * Vec2(direction.x(), -direction.y()), both, action.colour);
      const Vec2 out = action.out.isZero() ? Vec2(0.7, 0.7) : action.out;
      canvas.mark(action.at, 24.0 * Vec2(out.x() + 0.4, -out.y()), action.letter, action.colour);
    }
  for (const auto& contact : p.contacts)
    if (shows_gap(contact) && canvas.seen().holds(contact.drawn.at))
      canvas.note(contact.drawn.at, contact.options.name + ": " + gap_in_words(contact.drawn), "#2b2f36");
  canvas.axes(one ? "contact " + one->options.name : "whole, in mm");
}

/// What the picture of a contact shows: its fine zones, or its secondary boundary.
Box about(const sim::Problem& p, const sim::PlacedContact& contact) {
  Points x;
  for (const auto& zone : p.scene.geometry.fine_zones)
    if (zone.contact == contact.options.name)
      for (const Vec2& corner : corners_of(zone)) x.push_back(corner);
  const auto& mesh = p.shapes[contact.secondary.body]->mesh;
  if (x.empty())
    for (const auto& chain : mesh.boundaries.at(contact.secondary.boundary))
      for (const int node : chain) x.push_back(mesh.X[node]);
  return box_of(x);
}

Box whole(const sim::Problem& p) {
  Points x;
  for (const auto& shape : p.shapes) {
    const Box box = box_of(shape->mesh.X);
    x.push_back(box.low);
    x.push_back(box.high);
  }
  return box_of(x);
}

std::string material_in_words(const sim::Problem& p, int b) {
  const auto& input = p.inputs[b];
  if (p.rigid[b]) return "body " + input.name + ": rigid";
  const auto found = p.scene.body_material.find(input.name);
  return "body " + input.name + ": " + (found == p.scene.body_material.end() ? "" : found->second.material + ", ") +
         std::visit([](const auto& m) { return base::formatted("E %.6g MPa, nu %g", m.E_MPa, m.nu); }, input.material) +
         base::formatted(", %d elements", p.shapes[b]->mesh.cell_count());
}

/// Lines of the key, with a mark of their colour where they have one.
std::string key(const sim::Problem& p, const std::vector<Action>& actions, double& y) {
  std::string svg;
  const auto row = [&](const std::string& words, const std::string& mark, double from = gutter + 34.0) {
    svg += mark + key_lines(from, y, words, line_height);
  };
  const auto swatch = [&](const char* colour, double x) {
    return base::formatted(
        "<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"10\" fill=\"%s\" stroke=\"#4a5058\" "
        "stroke-width=\"0.6\"/>",
        x, y - 10.0, colour);
  };
  for (int b = 0; b < p.body_count(); ++b)
    row(material_in_words(p, b),
        swatch(p.rigid[b] ? "#cfd4da" : fills[static_cast<std::size_t>(b) % fills.size()], gutter));
  for (const auto& contact : p.contacts) {
    std::string primary;
    for (const auto& ref : contact.primary) primary += (primary.empty() ? "" : ", ") + ref.boundary;
    row("contact " + contact.options.name + ": secondary side " + contact.secondary.boundary +
            " (left), primary side " + primary + "; " + gap_in_words(contact.drawn) +
            base::formatted(" at (%.4g, %.4g) mm", contact.drawn.at.x(), contact.drawn.at.y()) +
            (contact.options.imposed ? "; its sliding is imposed" : ""),
        swatch(secondary_colour, gutter) + swatch(primary_colour, gutter + 15.0), gutter + 34.0);
  }
  for (const auto& bond : p.bonds) row("bond " + bond.options.name, swatch(bond_colour, gutter));
  for (const auto& action : actions) row(action.words, key_text(gutter + 2.0, y, action.letter, action.colour));
  if (!p.scene.geometry.fine_zones.empty())
    row("fine zones", base::formatted("<path d=\"M%.1f %.1fh20\" stroke=\"%s\" stroke-dasharray=\"5 3\"/>", gutter,
                                      y - 5.0, zone_colour));
  return svg;
}

}  // namespace

std::string scene_picture(const sim::Problem& p) {
  constexpr std::size_t most_contacts = 3;
  const auto actions = actions_of(p);
  const double panel_width = 0.5 * picture_width - 1.25 * gutter;
  std::string body;
  const std::size_t panels = 1 + std::min(most_contacts, p.contacts.size());
  for (std::size_t i = 0; i < panels; ++i) {
    const Vec2 low(gutter + static_cast<double>(i % 2) * (panel_width + gutter),
                   60.0 + static_cast<double>(i / 2) * (panel_height + gutter));
    const Box field{low, low + Vec2(panel_width, panel_height)};
    Canvas canvas(field, i == 0 ? whole(p) : about(p, p.contacts[i - 1]));
    draw(p, actions, i == 0 ? nullptr : &p.contacts[i - 1], canvas);
    body += canvas.svg(base::formatted("scene-field-%zu", i));
  }
  double y = 60.0 + static_cast<double>((panels + 1) / 2) * (panel_height + gutter);
  body += key(p, actions, y);
  y += line_height + 10.0;
  body += history_curves(p.scene.histories, gutter, y);
  return whole_picture(p.scene.title, gutter, body, y);
}

}  // namespace reye::output
