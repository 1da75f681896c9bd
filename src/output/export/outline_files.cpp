#include "output/export/outline_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "output/folder/csv.hpp"
#include "output/folder/text.hpp"
#include "output/report/drawn_frame.hpp"

namespace reye::output {

namespace {

/// A length in plain digits, as some readers of DXF know no exponents: 1e-12 mm.
std::string plain_number(double value) {
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 12).ptr;
  return {buffer.data(), end};
}

/// A pair of lines: code and value.
void add_group(std::string& dxf, int code, const std::string& value) {
  dxf += std::to_string(code) + '\n' + value + '\n';
}

bool is_layer_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

/// Names of layers as R12 knows them: few letters, 31 at most, all different.
std::vector<std::string> layers_of(const std::vector<WornBody>& bodies) {
  constexpr std::size_t longest = 31;
  std::vector<std::string> layers;
  std::set<std::string> used;
  for (const auto& body : bodies) {
    std::string plain = body.name;
    std::replace_if(
        plain.begin(), plain.end(), [](char c) { return !is_layer_letter(c); }, '_');
    std::string layer = plain.substr(0, longest);
    for (int k = 2; !used.insert(layer).second; ++k) {
      const std::string end = '_' + std::to_string(k);
      layer = plain.substr(0, longest - end.size()) + end;
    }
    layers.push_back(layer);
  }
  return layers;
}

void add_layers(std::string& dxf, const std::vector<std::string>& layers) {
  add_group(dxf, 0, "SECTION");
  add_group(dxf, 2, "TABLES");
  add_group(dxf, 0, "TABLE");
  add_group(dxf, 2, "LAYER");
  add_group(dxf, 70, std::to_string(layers.size()));
  for (std::size_t k = 0; k < layers.size(); ++k) {
    add_group(dxf, 0, "LAYER");
    add_group(dxf, 2, layers[k]);
    add_group(dxf, 70, "0");
    add_group(dxf, 62, std::to_string(1 + k % 7));  // the seven colours of the standard
    add_group(dxf, 6, "CONTINUOUS");
  }
  add_group(dxf, 0, "ENDTAB");
  add_group(dxf, 0, "ENDSEC");
}

void add_polyline(std::string& dxf, const mesh::Points& X, const mesh::Chain& loop, const std::string& layer) {
  const auto add_place = [&dxf](double x, double y) {
    add_group(dxf, 10, plain_number(x));
    add_group(dxf, 20, plain_number(y));
    add_group(dxf, 30, "0.0");
  };
  add_group(dxf, 0, "POLYLINE");
  add_group(dxf, 8, layer);
  add_group(dxf, 66, "1");  // vertices follow
  add_place(0.0, 0.0);
  add_group(dxf, 70, "1");  // closed
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
    add_group(dxf, 0, "VERTEX");
    add_group(dxf, 8, layer);
    add_place(X[loop[i]].x(), X[loop[i]].y());
  }
  add_group(dxf, 0, "SEQEND");
  add_group(dxf, 8, layer);
}

/// A comment of one line of plain characters, as R12 reads it.
std::string in_ascii(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return text.substr(0, 240);
}

}  // namespace

SideNames side_names(const std::string& path) {
  SideNames names;
  const DrawnSurfaces surfaces = read_drawn_surfaces(path);
  for (const auto& line : surfaces.lines)
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const std::string side = line.contact + (line.secondary ? " secondary" : " primary");
      std::string& name = names[{line.body, {surfaces.X[i].x(), surfaces.X[i].y()}}];
      if (name.empty())
        name = side;
      else if (name != side && !name.ends_with(" + " + side))
        name += " + " + side;
    }
  return names;
}

std::string outline_csv(const std::vector<WornBody>& bodies, const SideNames& sides, bool axisymmetric,
                        const std::string& note) {
  std::string text =
      "# " + note + "\nbody,loop," + (axisymmetric ? "r_mm" : "x_mm") + ",y_mm,wear_depth_mm,contact_side\n";
  for (const auto& body : bodies)
    for (std::size_t loop = 0; loop < body.mesh.outline.size(); ++loop)
      for (const int node : body.mesh.outline[loop]) {
        const auto& X = body.mesh.X[node];
        const auto side = sides.find({body.index, {X.x(), X.y()}});
        text += csv_field(body.name) + ',' + std::to_string(loop) + ',' + number(X.x()) + ',' + number(X.y()) + ',' +
                number(body.wear_depth_mm[static_cast<std::size_t>(node)]) + ',' +
                (side == sides.end() ? "" : csv_field(side->second)) + '\n';
      }
  return text;
}

std::string outline_dxf(const std::vector<WornBody>& bodies, const std::string& note) {
  std::string dxf;
  add_group(dxf, 999, in_ascii(note));
  add_group(dxf, 0, "SECTION");
  add_group(dxf, 2, "HEADER");
  add_group(dxf, 9, "$ACADVER");
  add_group(dxf, 1, "AC1009");  // R12
  add_group(dxf, 0, "ENDSEC");
  const auto layers = layers_of(bodies);
  add_layers(dxf, layers);
  add_group(dxf, 0, "SECTION");
  add_group(dxf, 2, "ENTITIES");
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const auto& loop : bodies[b].mesh.outline) add_polyline(dxf, bodies[b].mesh.X, loop, layers[b]);
  add_group(dxf, 0, "ENDSEC");
  add_group(dxf, 0, "EOF");
  return dxf;
}

std::vector<cad::PlaneFace> faces_of(const std::vector<WornBody>& bodies) {
  std::vector<cad::PlaneFace> faces;
  for (const auto& body : bodies) {
    cad::PlaneFace face{body.name, {}, body.mesh.cells.empty() ? 1 : mesh::order(body.mesh.kind)};
    for (const auto& loop : body.mesh.outline) {
      face.loops.emplace_back();
      for (std::size_t i = 0; i + 1 < loop.size(); ++i) face.loops.back().push_back(body.mesh.X[loop[i]]);
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

}  // namespace reye::output
