#include "output/solid/solid_picture.hpp"

#include <algorithm>
#include <array>

#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "output/folder/text.hpp"
#include "output/picture/key_pieces.hpp"
#include "output/solid/solid_panel.hpp"
#include "output/solid/solid_words.hpp"

namespace reye::output {

namespace {

constexpr double edge_gutter = 40.0, panel_gap = 30.0, solid_panel_height = 410.0, key_line = 19.0;
constexpr std::array body_colours{"#d5e0ec", "#efe3c8", "#d3e8da", "#e6d8ea", "#e4e4e0"};
constexpr const char *rigid_colour = "#c3c9d0", *secondary_face = "#e08a68", *primary_face = "#7fa6d6",
                     *held_face = "#c5aedb", *loaded_face = "#e0cd7a", *plain_face = "#dcd6cf";

/// Paints a face of a body where it has one of this name and none of more importance.
void paint_face(const BodyMeshes& bodies, const std::string& face, const char* colour, SkinPaint& paint) {
  const int b = body_with_face(bodies, face);
  if (b < 0) return;
  const auto body = static_cast<std::size_t>(b);
  if (paint.faces[body].try_emplace(face, colour).second) paint.rank[body].push_back(face);
}

SkinPaint paint_of(const scene::SolidScene& scene, const BodyMeshes& bodies) {
  SkinPaint paint;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    paint.body.emplace_back(scene.geometry.bodies[b].rigid ? rigid_colour : body_colours[b % body_colours.size()]);
  paint.faces.resize(bodies.size());
  paint.rank.resize(bodies.size());
  for (const auto& contact : scene.contacts) {
    paint_face(bodies, contact.secondary, secondary_face, paint);
    for (const auto& face : contact.primary) paint_face(bodies, face, primary_face, paint);
  }
  for (const auto& load : scene.loads) paint_face(bodies, load.face, loaded_face, paint);
  for (const auto& support : scene.supports) paint_face(bodies, support.face, held_face, paint);
  for (const auto& face : scene.geometry.faces) paint_face(bodies, face.name, plain_face, paint);
  return paint;
}

/// The corners of the boxes about some bodies.
Points3 box_corners(const BodyMeshes& bodies, const std::set<int>& shown) {
  Points3 x;
  for (const int b : shown)
    for (const auto& point : bodies[static_cast<std::size_t>(b)]->X) x.push_back(point);
  return x;
}

/// Names the faces that are seen, those `without` excepted.
void name_faces(SolidPanel& panel, const SkinPaint& paint, const std::set<std::string>& without,
                const std::set<int>& shown) {
  for (const int b : shown)
    for (const auto& face : paint.rank[static_cast<std::size_t>(b)]) {
      const auto at = without.count(face) ? std::nullopt : panel.seen_place(b, face);
      if (at) panel.name(*at, face, "#4a5058");
    }
}

/// Names the bodies, marks what acts on them. Faces that a letter stands for keep their names to the key.
void write_on(SolidPanel& panel, const scene::SolidScene& scene, const SkinPaint& paint,
              const std::vector<SolidAction>& actions, const std::set<int>& shown) {
  std::set<std::string> marked;
  for (const auto& action : actions) {
    if (!shown.count(action.body)) continue;
    marked.insert(action.face);
    if (const auto at = panel.seen_place(action.body, action.face)) panel.mark(*at, action);
  }
  for (const int b : shown)
    if (const auto at = panel.seen_place(b, ""))
      panel.name(*at, scene.geometry.bodies[static_cast<std::size_t>(b)].name, "#1b1e23");
  name_faces(panel, paint, marked, shown);
}

/// What a scene shows and where, while panels are added.
struct PanelRow {
  const scene::SolidScene& scene;
  const BodyMeshes& bodies;
  const SkinPaint& paint;
  const std::vector<SolidAction>& actions;
  std::string svg{};
  int count = 0;

  static double width() { return 0.5 * (picture_width - 2.0 * edge_gutter - panel_gap); }

  Box next_field() const {
    const Vec2 low(edge_gutter + (count % 2) * (width() + panel_gap),
                   66.0 + (count / 2) * (solid_panel_height + 2.0 * panel_gap));
    return {low, low + Vec2(width(), solid_panel_height)};
  }
  void add(const SpaceView& view, const std::set<int>& shown, const std::string& title, bool elements) {
    SolidPanel panel(view, bodies, paint, shown, elements);
    for (const auto& zone : scene.geometry.fine_zones) panel.zone(zone);
    if (elements)
      name_faces(panel, paint, {}, shown);
    else
      write_on(panel, scene, paint, actions, shown);
    svg += panel.svg(title, base::formatted("solid-field-%d", count++));
  }
  double end() const { return 66.0 + ((count + 1) / 2) * (solid_panel_height + 2.0 * panel_gap); }
};

/// Where one side of a contact is looked at: along its mean normal, a little from aside, and how much of it.
void add_side(const contact::SkinContactOptions& contact, const std::vector<std::string>& faces, const char* side,
              PanelRow& row) {
  const int b = faces.empty() ? -1 : body_with_face(row.bodies, faces.front());
  if (b < 0) return;
  const auto& mesh = *row.bodies[static_cast<std::size_t>(b)];
  Vec3 out = Vec3::Zero();
  Points3 shown;
  double area = 0.0;
  for (const auto& face : faces) {
    if (!mesh.faces.count(face)) continue;
    for (const auto& facet : mesh::facets_of(mesh, face)) {
      const Vec3 vector = mesh::area_vector(mesh.X, facet);
      out += vector;
      area += vector.norm();
      for (int k = 0; k < facet.count(); ++k)
        shown.push_back(mesh.X[static_cast<std::size_t>(facet.nodes[static_cast<std::size_t>(k)])]);
    }
  }
  for (const auto& zone : row.scene.geometry.fine_zones) {
    if (zone.contact != contact.name) continue;
    const Vec3 half = zone.radius_mm > 0.0 ? Vec3(Vec3::Constant(zone.radius_mm)) : zone.half_widths_mm;
    shown.clear();
    for (int axis = 0; axis < 3; ++axis)
      for (const double reach : {-2.2, 2.2}) shown.push_back(zone.centre_mm + reach * half[axis] * Vec3::Unit(axis));
    break;
  }
  const Vec3 normal = out.norm() > 0.05 * area ? Vec3(out.normalized()) : Vec3(0.5, -0.7, 0.6);
  const Vec3 above = std::abs(normal.z()) > 0.9 ? Vec3::UnitY() : Vec3::UnitZ();
  const SpaceView straight = space_view(normal, above, row.next_field(), shown);
  row.add(space_view(normal + 0.3 * straight.right + 0.4 * straight.up, above, row.next_field(), shown), {b},
          "contact " + contact.name + ", " + side + " side, " +
              row.scene.geometry.bodies[static_cast<std::size_t>(b)].name + " alone",
          true);
}

std::string swatch_of(const char* colour, double x, double y) {
  return base::formatted(
      "<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"10\" fill=\"%s\" stroke=\"#4a5058\" stroke-width=\"0.6\"/>", x,
      y - 10.0, colour);
}

std::string names_of(const std::vector<std::string>& names) {
  std::string all;
  for (const auto& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

std::string body_in_words(const PanelRow& row, std::size_t b) {
  const auto& body = row.scene.geometry.bodies[b];
  const auto& mesh = *row.bodies[b];
  return "body " + body.name + ": " + solid_material_in_words(row.scene, body) +
         base::formatted(", %d nodes", mesh.node_count()) +
         (mesh.cells.empty() ? base::formatted(", %zu facets", mesh.skin.size())
                             : base::formatted(", %d elements", mesh.cell_count()));
}

std::string contact_in_words(const contact::SkinContactOptions& contact) {
  std::string words = "contact " + contact.name + ": secondary side " + contact.secondary + " (left), primary side " +
                      names_of(contact.primary) + "; friction " + rounded(contact.friction);
  for (const auto& sliding : contact.sliding) words += "; sliding " + sliding_in_words(sliding);
  return words;
}

/// Lines of the key, with a mark of their colour where they have one.
std::string key_of(const PanelRow& row, double& y) {
  std::string svg;
  const auto line = [&](const std::string& words, const std::string& mark) {
    svg += mark + key_lines(edge_gutter + 34.0, y, words, key_line);
  };
  for (std::size_t b = 0; b < row.bodies.size(); ++b)
    line(body_in_words(row, b), swatch_of(row.paint.body[b].c_str(), edge_gutter, y));
  for (const auto& contact : row.scene.contacts)
    line(contact_in_words(contact),
         swatch_of(secondary_face, edge_gutter, y) + swatch_of(primary_face, edge_gutter + 15.0, y));
  for (const auto& action : row.actions)
    line(action.words, key_text(edge_gutter + 2.0, y, action.letter, action.colour));
  for (const auto& zone : row.scene.geometry.fine_zones)
    line("fine zone" + (zone.contact.empty() ? "" : " of contact " + zone.contact) + ": elements of " +
             rounded(zone.size_mm) + " mm about " + place_in_words(zone.centre_mm) + " mm",
         base::formatted("<path d=\"M%.1f %.1fh26\" stroke=\"#5a616b\" stroke-dasharray=\"5 3\"/>", edge_gutter,
                         y - 5.0));
  return svg;
}

}  // namespace

std::string solid_picture(const scene::SolidScene& scene, const BodyMeshes& bodies) {
  constexpr std::size_t most_contacts = 3;
  const SkinPaint paint = paint_of(scene, bodies);
  const auto actions = solid_actions(scene, bodies);
  PanelRow row{scene, bodies, paint, actions};
  std::set<int> all;
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) all.insert(b);
  const auto corners = box_corners(bodies, all);
  row.add(space_view({0.62, -1.0, 0.55}, Vec3::UnitZ(), row.next_field(), corners), all, "from the front and above",
          false);
  row.add(space_view({-0.62, 1.0, -0.45}, Vec3::UnitZ(), row.next_field(), corners), all, "from behind and below",
          false);
  for (std::size_t c = 0; c < std::min(most_contacts, scene.contacts.size()); ++c) {
    add_side(scene.contacts[c], {scene.contacts[c].secondary}, "secondary", row);
    add_side(scene.contacts[c], scene.contacts[c].primary, "primary", row);
  }
  double y = row.end();
  std::string content = row.svg + key_of(row, y);
  y += key_line + 10.0;
  content += history_curves(scene.histories, edge_gutter, y);
  return whole_picture(scene.title, edge_gutter, content, y);
}

std::string solid_picture(const scene::SolidScene& scene, const std::vector<mesh::SolidMesh>& bodies) {
  BodyMeshes pointers;
  for (const auto& body : bodies) pointers.push_back(&body);
  return solid_picture(scene, pointers);
}

std::string solid_picture(const scene::SolidScene& scene, const std::vector<body::SolidInput>& bodies) {
  BodyMeshes pointers;
  for (const auto& body : bodies) pointers.push_back(body.mesh.get());
  return solid_picture(scene, pointers);
}

}  // namespace reye::output
