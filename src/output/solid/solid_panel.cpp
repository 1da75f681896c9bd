#include "output/solid/solid_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "output/folder/text.hpp"
#include "output/solid/skin_edges.hpp"

namespace reye::output {

namespace {

/// The corners of a facet round it, with its mid nodes between them.
Points3 round_facet(const mesh::SolidMesh& mesh, const mesh::Facet& f) {
  static constexpr std::array<int, 6> curved{0, 3, 1, 4, 2, 5};
  Points3 x;
  for (int k = 0; k < f.count(); ++k)
    x.push_back(mesh.X[static_cast<std::size_t>(
        f.nodes[static_cast<std::size_t>(f.kind == mesh::FacetKind::tri6 ? curved[static_cast<std::size_t>(k)] : k)])]);
  return x;
}

/// A colour in the light from above the viewer's left shoulder, in a few steps.
std::string lit(const std::string& colour, const Vec3& normal, const SpaceView& view) {
  constexpr double steps = 14.0, dark = 0.62;
  const Vec3 light = (0.9 * view.toward + 0.55 * view.up - 0.35 * view.right).normalized();
  const double share = std::round(steps * std::max(0.0, normal.dot(light))) / steps;
  const double factor = dark + (1.0 - dark) * share;
  std::string result = "#";
  for (std::size_t c = 0; c < 3; ++c)
    result += base::formatted(
        "%02x",
        static_cast<unsigned>(std::lround(factor * std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16))) & 255u);
  return result;
}

/// The colour of each facet of a body.
std::vector<const std::string*> colours_of(const mesh::SolidMesh& mesh, const SkinPaint& paint, std::size_t b) {
  std::vector<const std::string*> colours(mesh.skin.size(), &paint.body[b]);
  for (auto name = paint.rank[b].rbegin(); name != paint.rank[b].rend(); ++name)
    for (const int f : mesh.faces.at(*name)) colours[static_cast<std::size_t>(f)] = &paint.faces[b].at(*name);
  return colours;
}

std::string dashed_line(const std::vector<Vec2>& pixels) {
  std::string path;
  for (const Vec2& p : pixels) path += (path.empty() ? 'M' : 'L') + base::fixed(p.x(), 1) + ' ' + base::fixed(p.y(), 1);
  return path;
}

std::string arrow_svg(const Vec2& tail, const Vec2& tip, bool both, const std::string& colour) {
  const Vec2 along = (tip - tail).normalized(), across(-along.y(), along.x());
  const auto head = [&](const Vec2& at, const Vec2& back) {
    const Vec2 a = at + 8.0 * back + 3.5 * across, b = at + 8.0 * back - 3.5 * across;
    return base::formatted("<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" fill=\"%s\"/>", at.x(), at.y(), a.x(), a.y(),
                           b.x(), b.y(), colour.c_str());
  };
  return base::formatted("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"2\"/>", tail.x(), tail.y(),
                         tip.x(), tip.y(), colour.c_str()) +
         head(tip, -along) + (both ? head(tail, along) : "") + '\n';
}

bool overlap(const Box& a, const Box& b) {
  return a.low.x() < b.high.x() && b.low.x() < a.high.x() && a.low.y() < b.high.y() && b.low.y() < a.high.y();
}

}  // namespace

SolidPanel::SolidPanel(const SpaceView& view, const BodyMeshes& bodies, const SkinPaint& paint,
                       const std::set<int>& shown, bool elements)
    : view_(view), bodies_(bodies), paint_(paint), depth_(view), shown_(shown) {
  for (const int b : shown) {
    const auto& mesh = *bodies[static_cast<std::size_t>(b)];
    const auto colours = colours_of(mesh, paint, static_cast<std::size_t>(b));
    for (std::size_t f = 0; f < mesh.skin.size(); ++f) {
      const Vec3 normal = mesh::area_vector(mesh.X, mesh.skin[f]).normalized();
      if (normal.dot(view.toward) > -0.02) depth_.add(round_facet(mesh, mesh.skin[f]), lit(*colours[f], normal, view));
    }
  }
  for (const int b : shown) draw_edges(bodies, b, elements);
  const Vec2 low = view.field.low, high = view.field.high;  // of axes and bar of size
  taken_.push_back({{low.x(), high.y() - 78.0}, {low.x() + 78.0, high.y()}});
  taken_.push_back({{high.x() - 150.0, high.y() - 30.0}, high});
}

std::string SolidPanel::seen_parts(const Vec3& a, const Vec3& b) const {
  const Vec2 p = view_.pixel(a), q = view_.pixel(b);
  const int parts = std::clamp(static_cast<int>((q - p).norm() / 2.0), 1, 400);
  std::string path;
  bool down = false;
  for (int i = 0; i < parts; ++i) {
    const bool seen = depth_.sees(a + (i + 0.5) / parts * (b - a));
    const auto at = [&](int k) {
      const Vec2 x = p + static_cast<double>(k) / parts * (q - p);
      return base::fixed(x.x(), 1) + ' ' + base::fixed(x.y(), 1);
    };
    if (seen && !down) path += 'M' + at(i);
    if (down && !seen) path += 'L' + at(i);
    if (seen && i + 1 == parts) path += 'L' + at(parts);
    down = seen;
  }
  return path;
}

void SolidPanel::draw_edges(const BodyMeshes& bodies, int body, bool elements) {
  constexpr double least_pixels = 3.5;
  constexpr std::size_t most = 9000;
  const auto& mesh = *bodies[static_cast<std::size_t>(body)];
  const auto edges = skin_edges(mesh);
  std::vector<const SkinEdge*> inner;
  double length = 0.0;
  for (const auto& edge : edges) {
    const Vec3 &a = mesh.X[static_cast<std::size_t>(edge.from)], &b = mesh.X[static_cast<std::size_t>(edge.to)];
    const bool facing = edge.left.dot(view_.toward) > 0.0, other = edge.right.dot(view_.toward) > 0.0;
    if (!facing && !other) continue;
    if (edge.feature || facing != other) {
      feature_lines_ += seen_parts(a, b);
    } else if (view_.field.holds(view_.pixel(a)) || view_.field.holds(view_.pixel(b))) {
      inner.push_back(&edge);
      length += (view_.pixel(a) - view_.pixel(b)).norm();
    }
  }
  if (!elements || inner.size() > most || length < least_pixels * static_cast<double>(inner.size())) return;
  for (const auto* edge : inner)
    element_lines_ +=
        seen_parts(mesh.X[static_cast<std::size_t>(edge->from)], mesh.X[static_cast<std::size_t>(edge->to)]);
}

std::optional<Vec3> SolidPanel::seen_place(int body, const std::string& face) const {
  const auto& mesh = *bodies_[static_cast<std::size_t>(body)];
  std::vector<char> wanted(mesh.skin.size(), face.empty());
  if (face.empty())
    for (const auto& name : paint_.rank[static_cast<std::size_t>(body)])
      for (const int f : mesh.faces.at(name)) wanted[static_cast<std::size_t>(f)] = 0;
  else
    for (const int f : mesh.faces.at(face)) wanted[static_cast<std::size_t>(f)] = 1;
  std::vector<std::pair<Vec3, double>> seen;  // with the area in the picture
  Vec3 sum = Vec3::Zero();
  double whole = 0.0;
  for (std::size_t f = 0; f < mesh.skin.size(); ++f) {
    const double area = wanted[f] ? mesh::area_vector(mesh.X, mesh.skin[f]).dot(view_.toward) : 0.0;
    if (!(area > 0.0)) continue;
    Vec3 at = Vec3::Zero();
    const auto corners = round_facet(mesh, mesh.skin[f]);
    for (const Vec3& x : corners) at += x / static_cast<double>(corners.size());
    if (!depth_.sees(at)) continue;
    seen.emplace_back(at, area);
    sum += area * at;
    whole += area;
  }
  if (whole * view_.pixels_per_mm * view_.pixels_per_mm < 40.0) return {};
  const auto nearest = std::min_element(seen.begin(), seen.end(), [&](const auto& a, const auto& b) {
    return (a.first - sum / whole).squaredNorm() < (b.first - sum / whole).squaredNorm();
  });
  return nearest->first;
}

Vec2 SolidPanel::free_place(const Vec2& wanted, const Vec2& size) {
  const Vec2 low = view_.field.low + Vec2(3.0, 3.0), high = view_.field.high - Vec2(3.0, 3.0) - size;
  Vec2 at = wanted.cwiseMin(high).cwiseMax(low);
  for (int ring = 0; ring < 14; ++ring)
    for (int k = 0; k < (ring == 0 ? 1 : 12); ++k) {
      const double angle = k * 0.5235987756 + 0.4, reach = 9.0 * ring;
      const Vec2 tried = (wanted + reach * Vec2(1.3 * std::cos(angle), -std::sin(angle))).cwiseMin(high).cwiseMax(low);
      const Box box{tried, tried + size};
      if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& other) { return overlap(box, other); })) continue;
      taken_.push_back(box);
      return tried;
    }
  taken_.push_back({at, at + size});
  return at;
}

void SolidPanel::name(const Vec3& at, const std::string& words, const std::string& colour) {
  const auto letters = std::count_if(words.begin(), words.end(), [](char c) { return (c & 0xC0) != 0x80; });
  const Vec2 size(6.8 * static_cast<double>(letters) + 4.0, 16.0), p = view_.pixel(at);
  const Vec2 box = free_place(p - 0.5 * size, size), middle = box + 0.5 * size;
  if ((middle - p).norm() > 22.0)
    above_ += base::formatted("<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"0.9\"/>", p.x(), p.y(),
                              middle.x(), middle.y(), colour.c_str());
  above_ += base::formatted(
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"12.5\" font-weight=\"600\" "
                "fill=\"%s\" stroke=\"#fff\" stroke-width=\"3.2\" stroke-linejoin=\"round\" paint-order=\"stroke\">",
                middle.x(), middle.y() + 4.5, colour.c_str()) +
            escaped(words) + "</text>\n";
}

void SolidPanel::mark(const Vec3& at, const SolidAction& action) {
  constexpr double radius = 9.0, length = 36.0, least = 0.25;
  const Vec2 p = view_.pixel(at);
  for (const auto& [direction, both] : action.arrows) {
    const Vec2 way = view_.along(direction) / view_.pixels_per_mm;
    if (way.norm() < least) continue;  // towards the viewer
    const Vec2 arrow = length * std::max(way.norm(), 0.6) * way.normalized();
    above_ += both ? arrow_svg(p - 0.5 * arrow, p + 0.5 * arrow, true, action.colour)
                   : arrow_svg(p - arrow, p, false, action.colour);
    taken_.push_back({(p - 0.5 * arrow.cwiseAbs()).eval(), (p + 0.5 * arrow.cwiseAbs()).eval()});
  }
  const Vec2 size(2.0 * radius + 2.0, 2.0 * radius + 2.0);
  const Vec2 c = free_place(p + Vec2(10.0, -30.0), size) + 0.5 * size;
  above_ += base::formatted(
      "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\"/><circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.4\" fill=\"%s\"/>"
      "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%g\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"1.4\"/>"
      "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"11\" font-weight=\"bold\" "
      "fill=\"%s\">%s</text>\n",
      p.x(), p.y(), c.x(), c.y(), action.colour, p.x(), p.y(), action.colour, c.x(), c.y(), radius, action.colour,
      c.x(), c.y() + 4.0, action.colour, action.letter.c_str());
}

void SolidPanel::zone(const cad::SolidFineZone& zone) {
  if (zone.radius_mm > 0.0) {
    const Vec2 c = view_.pixel(zone.centre_mm);
    const double r = view_.pixels_per_mm * zone.radius_mm;
    dashed_ += base::formatted("M%.1f %.1fa%.1f %.1f 0 1 0 %.1f 0a%.1f %.1f 0 1 0 %.1f 0", c.x() - r, c.y(), r, r,
                               2.0 * r, r, r, -2.0 * r);
    return;
  }
  const auto corner = [&](int k) {
    const Vec3 sign(k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0);
    return view_.pixel(zone.centre_mm + sign.cwiseProduct(zone.half_widths_mm));
  };
  for (int k = 0; k < 8; ++k)
    for (const int axis : {1, 2, 4})
      if (!(k & axis)) dashed_ += dashed_line({corner(k), corner(k | axis)});
}

namespace {

/// The directions x, y, z of space.
std::string axes_svg(const SpaceView& view) {
  constexpr std::array names{"x", "y", "z"};
  constexpr std::array colours{"#b3402f", "#2f8f5b", "#1f5fa8"};
  const Vec2 origin(view.field.low.x() + 40.0, view.field.high.y() - 40.0);
  std::string out = base::formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"37\" fill=\"#fff\" fill-opacity=\"0.75\"/>\n",
                                    origin.x(), origin.y());
  for (int i = 0; i < 3; ++i) {
    const Vec2 way = 24.0 * view.along(Vec3::Unit(i)) / view.pixels_per_mm, tip = origin + way,
               name = tip + (way.norm() > 4.0 ? Vec2(8.0 * way.normalized()) : Vec2(-7.0, 7.0));
    out += base::formatted(
        "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"1.8\"/><text x=\"%.1f\" y=\"%.1f\" "
        "text-anchor=\"middle\" font-size=\"12\" fill=\"%s\">%s</text>\n",
        origin.x(), origin.y(), tip.x(), tip.y(), colours[static_cast<std::size_t>(i)], name.x(), name.y() + 4.0,
        colours[static_cast<std::size_t>(i)], names[static_cast<std::size_t>(i)]);
  }
  return out;
}

/// A bar of a round length.
std::string size_bar(const SpaceView& view) {
  const double most = 120.0 / view.pixels_per_mm, power = std::pow(10.0, std::floor(std::log10(most)));
  const double mm = (most >= 5.0 * power ? 5.0 : most >= 2.0 * power ? 2.0 : 1.0) * power;
  const double length = mm * view.pixels_per_mm, x = view.field.high.x() - 14.0, y = view.field.high.y() - 10.0;
  return base::formatted(
             "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"29\" fill=\"#fff\" fill-opacity=\"0.75\"/>",
             x - length - 8.0, y - 21.0, length + 16.0) +
         base::formatted("<path d=\"M%.1f %.1fv5h%.1fv-5\" fill=\"none\" stroke=\"#2b2f36\" stroke-width=\"1.3\"/>",
                         x - length, y - 5.0, length) +
         base::formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"12\" fill=\"#2b2f36\">",
                         x - 0.5 * length, y - 6.0) +
         escaped(rounded(mm) + " mm") + "</text>\n";
}

}  // namespace

std::string SolidPanel::svg(const std::string& title, const std::string& id) const {
  const Box& f = view_.field;
  const std::string box = base::formatted("x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"", f.low.x(), f.low.y(),
                                          f.size().x(), f.size().y());
  const auto lines = [](const std::string& path, const char* style) {
    return path.empty() ? "" : "<path d=\"" + path + "\" fill=\"none\" " + style + "/>\n";
  };
  return "<clipPath id=\"" + id + "\"><rect " + box + "/></clipPath>\n<g clip-path=\"url(#" + id + ")\">\n" +
         depth_.svg() + lines(element_lines_, "stroke=\"#2b2f36\" stroke-opacity=\"0.22\" stroke-width=\"0.5\"") +
         lines(feature_lines_, "stroke=\"#2b2f36\" stroke-width=\"0.9\" stroke-linecap=\"round\"") +
         lines(dashed_, "stroke=\"#5a616b\" stroke-width=\"1.1\" stroke-dasharray=\"5 3\"") + above_ + axes_svg(view_) +
         size_bar(view_) + "</g>\n<rect " + box + " fill=\"none\" stroke=\"#b6bcc4\"/>\n" +
         base::formatted("<text x=\"%.1f\" y=\"%.1f\" font-size=\"13\" font-weight=\"bold\" fill=\"#2b2f36\">",
                         f.low.x(), f.low.y() - 8.0) +
         escaped(title) + "</text>\n";
}

}  // namespace reye::output
