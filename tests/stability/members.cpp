#include "stability/members.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>

#include "stability/scenes.hpp"

namespace reye::test {

namespace {

std::string words(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Flat blocks: sharp corners of the slider press on the base.
Member flat(const std::string& group, const std::string& name) {
  Member m;
  m.group = group;
  m.name = name;
  m.scene = rubbing;
  m.blocks.slider = {.x0 = 1.0, .x1 = 3.0, .nx = 8, .ny = 4};
  m.blocks.base = {.x0 = 0.0, .x1 = 4.0, .y0 = -1.0, .nx = 14, .ny = 4};
  return m;
}

/// A crowned slider, radius 20, in partial slip: half width 0.12, ten elements across.
Member crowned(const std::string& group, const std::string& name) {
  Member m = flat(group, name);
  m.blocks.slider = {.x0 = 1.0, .x1 = 3.0, .nx = 40, .ny = 6, .grade_x = 2.0, .grade_y = 2.0, .crown_mm = 20.0};
  m.blocks.base = {.x0 = 0.0, .x1 = 4.0, .y0 = -1.0, .nx = 50, .ny = 6, .grade_x = 2.0, .grade_y = 2.0};
  m.set("support.holder.y.force_N_per_mm", "@N_per_mm(-60.0)").set("support.holder.x.motion_mm", "@mm(0.0005)");
  return m;
}

/// Blocks at finite strain with a drop-off edge.
Member rubber(const std::string& group, const std::string& name) {
  Member m = flat(group, name);
  m.scene = drawn;
  m.budget = 4000;
  return m;
}

using Table = std::vector<Member>;

/// Both sides' coefficient.
Member& wear_by(Member& m, const std::string& coefficient) {
  return m.set("contact.pad.wear.secondary_mm3_per_J", coefficient)
      .set("contact.pad.wear.primary_mm3_per_J", coefficient);
}

void references(Table& t) {
  t.push_back(flat("reference", "flat"));
  t.push_back(crowned("reference", "crowned"));
  t.push_back(rubber("reference", "rubber"));
}

void friction(Table& t) {
  // Without friction Archard's law wears, along a sliding that is imposed.
  const std::string archard =
      "{ law = \"archard\", secondary_per_MPa = @per_MPa(1.0e-8), primary_per_MPa = @per_MPa(1.0e-8) }";
  for (Member m :
       {flat("friction", "flat_mu_0"), crowned("friction", "crowned_mu_0"), rubber("friction", "rubber_mu_0")})
    t.push_back(m.set("contact.pad.wear", archard)
                    .set("contact.pad.friction", "0.0")
                    .set("contact.pad.imposed_sliding_mm", "@mm(0.01)"));
  for (const char* mu : {"1e-6", "0.1", "0.6", "1", "2"})
    for (Member m :
         {flat("friction", "flat_mu_"), crowned("friction", "crowned_mu_"), rubber("friction", "rubber_mu_")}) {
      m.name += mu;
      m.set("contact.pad.friction", mu);
      // Depths far below a nanometre are lost in the digits of the coordinates.
      if (std::stod(mu) < 1e-3) wear_by(m, "@mm3_per_J(1.0)");
      t.push_back(m);
    }
}

/// Coefficients of both sides so that one increment wears `times` what explicit wear stands: k ds E* = 4 h / pi.
void wear_beyond_explicit(Table& t) {
  for (double times : {1.0, 1e2, 1e3, 1e4}) {
    constexpr double modulus = 1.1e5, slide = 0.005, jump = 10.0;
    const auto coefficient = [&](double h, double mu) {
      return words("@mm3_per_J(%.6g)", 1e3 * times * 4.0 * h / (3.14159265 * modulus * slide * jump) / (2.0 * mu));
    };
    const std::string name = words("explicit_x_%g", times);
    // Slip that is not imposed: what wears sticks or slips by what it has worn. At 10^4 times the limit that does not
    // converge, however short the increment: the blocks are shortened until it does.
    const auto limit = [&](Member m) {
      if (times > 1e3) m.budget = 3000;
      return m;
    };
    const auto add = [&](Member m, double h, double mu) {
      t.push_back(wear_by(m.set("contact.pad.friction", words("%g", mu)), coefficient(h, mu)));
    };
    const auto imposed = [](Member m) {
      return m.set("contact.pad.imposed_sliding_mm", "@mm(0.04)")
          .set("support.holder.x", "\"fixed\"")
          .set("step[1].play", "[]");
    };
    // By a light load, that the blocks do not wear away.
    const auto light = [](Member m, const char* force) { return m.set("support.holder.y.force_N_per_mm", force); };
    add(limit(light(flat("wear", "flat_" + name), "@N_per_mm(-0.02)")), 0.25, 0.3);
    add(light(imposed(flat("wear", "flat_imposed_" + name)), "@N_per_mm(-0.02)"), 0.25, 0.3);
    add(light(imposed(crowned("wear", "crowned_imposed_" + name)), "@N_per_mm(-0.2)"), 0.0025, 0.3);
    add(limit(crowned("wear", "crowned_gap_" + name)
                  .set("shape", "\"off\"")
                  .set("support.holder.x.motion_mm", "@mm(0.01)")),
        0.0025, 0.3);
    add(imposed(crowned("wear", "crowned_gap_imposed_" + name)).set("shape", "\"off\""), 0.0025, 0.3);
  }
}

/// Element sizes on the contact 20 to 1 either way, either side secondary.
void mesh_ratios(Table& t) {
  for (bool swapped : {false, true})
    for (bool fine_slider : {false, true}) {
      const std::string name =
          std::string(fine_slider ? "fine_slider" : "fine_base") + (swapped ? "_base_secondary" : "");
      Member m = flat("mesh ratio", "flat_" + name), r = rubber("mesh ratio", "rubber_" + name);
      for (Member* x : {&m, &r}) {
        x->blocks.slider.nx = fine_slider ? 40 : 2;
        x->blocks.base.nx = fine_slider ? 4 : 80;
        if (swapped) x->set("contact.pad.secondary", "\"base_top\"").set("contact.pad.primary", "[\"slider_bottom\"]");
        t.push_back(*x);
      }
    }
}

void stiffness_ratios(Table& t) {
  for (const char* E : {"2e3", "20", "0.2"})
    for (const char* body : {"upper", "lower"}) {
      const std::string key = std::string("material.") + body + ".E_MPa", name = std::string(body) + "_E_" + E;
      const std::string value = std::string("@MPa(") + E + ")";
      // The soft body must still strain little.
      const auto add = [&](Member m, double strain) {
        m.set(key, value).set("support.holder.y.force_N_per_mm", words("@N_per_mm(%g)", -strain * std::stod(E)));
        t.push_back(wear_by(m, words("@mm3_per_J(%g)", 1e-3 / (strain * std::stod(E)))));
      };
      add(flat("stiffness ratio", "flat_" + name), 1e-4);
      add(crowned("stiffness ratio", "crowned_" + name).set("support.holder.x.motion_mm", "@mm(0.01)"), 1e-4);
    }
  for (const char* E : {"1e4", "1e6", "1e8"})
    for (const char* body : {"upper", "lower"})
      t.push_back(rubber("stiffness ratio", std::string("rubber_") + body + "_E_" + E)
                      .set(std::string("material.") + body + ".E_MPa", std::string("@MPa(") + E + ")"));
}

void incompressible(Table& t) {
  for (const char* nu : {"0", "0.49", "0.4999"})
    for (const auto& [kind, word] : {std::pair{Element::quad4, "q4"}, {Element::quad8, "q8"}, {Element::tri6, "t6"}}) {
      Member m = flat("nu", std::string("flat_") + word + "_nu_" + nu),
             r = rubber("nu", std::string("rubber_") + word + "_nu_" + nu);
      for (Member* x : {&m, &r}) {
        x->blocks.slider.element = x->blocks.base.element = kind;
        t.push_back(x->set("material.upper.nu", nu).set("material.lower.nu", nu));
      }
    }
}

/// Sliding over the edge of the base, by either side secondary.
void corners(Table& t) {
  for (const char* way : {"0.9", "1.3", "1.9"}) {
    const std::string motion = std::string("@mm(") + way + ")";
    t.push_back(flat("drop-off", std::string("flat_way_") + way).set("support.holder.x.motion_mm", motion));
    t.push_back(flat("drop-off", std::string("flat_base_secondary_way_") + way)
                    .set("support.holder.x.motion_mm", motion)
                    .set("contact.pad.secondary", "\"base_top\"")
                    .set("contact.pad.primary", "[\"slider_bottom\"]"));
    t.push_back(rubber("drop-off", std::string("rubber_way_") + way).set("support.holder.x.motion_mm", motion));
  }
}

/// Pressed, lifted off altogether and pressed again.
void separation(Table& t) {
  for (const char* lift : {"1e-6", "1e-3", "0.1", "0.5"}) {
    const auto lifted = [&](Member m, const char* depth) {
      m.set("support.holder.y", std::string("{ motion_mm = @mm(1.0), history = \"lift\" }"));
      m.set("history.lift",
            std::string("[[0.0, -") + depth + "], [0.4, " + lift + "], [0.6, " + lift + "], [1.0, -" + depth + "]]");
      m.set("step[1].play", m.scene == std::string(drawn) ? "[\"draw\", \"lift\"]" : "[\"stroke\", \"lift\"]");
      t.push_back(m);
    };
    lifted(flat("separation", std::string("flat_lift_") + lift), "1e-4");
    lifted(crowned("separation", std::string("crowned_lift_") + lift), "5e-4");
    lifted(rubber("separation", std::string("rubber_lift_") + lift).set("support.holder.x.motion_mm", "@mm(0.5)"),
           "0.15");
  }
  // Pulled off by a force nothing holds the slider.
  t.push_back(flat("separation", "flat_pulled_off")
                  .set("history.press", "[[0.0, 0.0], [0.5, 1.0], [1.0, -1.0]]")
                  .refused("body slider has come away from contact pad"));
}

void tiny_gaps(Table& t) {
  for (double gap : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-1}) {
    Member m = flat("gap", words("flat_gap_%g", gap)), c = crowned("gap", words("crowned_gap_%g", gap));
    for (Member* x : {&m, &c}) {
      x->blocks.slider.y0 = gap;
      t.push_back(*x);
    }
  }
}

void meshes(Table& t) {
  Member one = flat("mesh", "one_element_each"), two = rubber("mesh", "rubber_coarse");
  one.blocks.slider.nx = one.blocks.slider.ny = one.blocks.base.nx = one.blocks.base.ny = 1;
  two.blocks.slider.nx = two.blocks.slider.ny = two.blocks.base.ny = 1;
  two.blocks.base.nx = 2;
  t.insert(t.end(), {one, two});
  for (double by : {0.1, 0.2, 0.3}) {
    Member m = flat("mesh", words("flat_distorted_%g", by)), r = rubber("mesh", words("rubber_distorted_%g", by));
    for (Member* x : {&m, &r}) {
      x->blocks.slider.distort = x->blocks.base.distort = by;
      t.push_back(*x);
    }
  }
}

void orders(Table& t) {
  const std::array<std::pair<Element, const char*>, 4> kinds{
      {{Element::tri3, "t3"}, {Element::quad4, "q4"}, {Element::tri6, "t6"}, {Element::quad8, "q8"}}};
  for (const auto& [upper, above] : kinds)
    for (const auto& [lower, below] : kinds) {
      if (upper == Element::quad4 && lower == Element::quad4) continue;
      const std::string name = std::string(above) + "_on_" + below;
      Member m = flat("orders", "flat_" + name), c = crowned("orders", "crowned_" + name),
             r = rubber("orders", "rubber_" + name);
      for (Member* x : {&m, &c, &r}) {
        x->blocks.slider.element = upper;
        x->blocks.base.element = lower;
      }
      t.insert(t.end(), {m, r});
      const bool second = upper == Element::quad8 || upper == Element::tri6;
      if (second) t.push_back(c);
      if (second) t.push_back(r.set("contact.pad.dual", "\"linear\"")), t.back().name += "_linear_dual";
    }
}

/// The whole way in one increment.
void huge_increments(Table& t) {
  for (const char* way : {"0.1", "0.5", "1"}) {
    t.push_back(flat("increments", std::string("flat_whole_way_") + way)
                    .set("support.holder.x.motion_mm", std::string("@mm(") + way + ")")
                    .set("history.stroke", "[[0.0, 0.0], [1.0, 1.0]]")
                    .set("step[1].increments", "1")
                    .set("step[1].cycles", "1")
                    .set("step[1].jump", "1"));
    t.push_back(rubber("increments", std::string("rubber_whole_way_") + way)
                    .set("support.holder.x.motion_mm", std::string("@mm(") + way + ")")
                    .set("step[0].increments", "1")
                    .set("step[1].increments", "1"));
  }
  const auto at_once = [](const std::string& depth) {
    return rubber("increments", "rubber_pressed_at_once_" + depth)
        .set("support.holder.y.motion_mm", "@mm(" + depth + ")")
        .set("step[0].increments", "1");
  };
  t.push_back(at_once("-0.3"));
  // Drawn by more than 0.5 mm this one loses its hold: the edge springs off, and no state in touch follows.
  t.push_back(at_once("-0.5").set("support.holder.x.motion_mm", "@mm(0.4)"));
  t.push_back(
      crowned("increments", "crowned_pressed_200_times").set("support.holder.y.force_N_per_mm", "@N_per_mm(-12e3)"));
}

/// The factors of the complementarity functions steer the iteration, never its end.
void complementarity(Table& t) {
  for (const char* c : {"1e-4", "1e-2", "1e2", "1e4"})
    for (const char* key : {"c_normal", "c_tangential"}) {
      const std::string name = std::string("_") + key + "_" + c, whole = std::string("contact.pad.") + key;
      t.push_back(flat("c", "flat" + name).set(whole, c).same_as("flat", 1e-8));
      t.push_back(crowned("c", "crowned" + name).set(whole, c).same_as("crowned", 1e-8));
      t.push_back(rubber("c", "rubber" + name).set(whole, c).same_as("rubber", 1e-8));
    }
}

void units(Table& t) {
  for (double x : {1e-6, 1e6})
    for (const auto& [word, u] : {std::pair{"length", Units{x, 1.0}}, {"force", Units{1.0, x}}, {"both", Units{x, x}}})
      for (Member m : {flat("units", "flat"), crowned("units", "crowned"), rubber("units", "rubber")}) {
        m.same_as(m.name, 1e-9).name += std::string("_") + word + words("_%g", x);
        m.units = u;
        t.push_back(m);
      }
}

/// Noise on every node must move the figures no more than its size says.
void noise(Table& t) {
  for (unsigned seed : {1U, 2U, 3U})
    for (Member m : {flat("noise", "flat"), crowned("noise", "crowned"), rubber("noise", "rubber")}) {
      m.blocks.slider.noise = m.blocks.base.noise = 1e-10;
      m.blocks.seed = seed;
      m.same_as(m.name, 1e-3).name += "_noise_" + std::to_string(seed);
      t.push_back(m);
    }
}

void remeshed(Table& t) {
  for (Member m : {flat("remesh", "flat_remeshed"), crowned("remesh", "crowned_remeshed")})
    t.push_back(m.set("remesh.every_blocks", "1").set("step[1].cycles", "60"));
  t.push_back(rubber("remesh", "rubber_remeshed")
                  .set("remesh.every_blocks", "1")
                  .set("step[1].cycles", "3")
                  .set("history.draw", "[[0.0, 0.0], [0.5, 1.0], [1.0, 0.0]]"));
}

Table all() {
  Table t;
  for (const auto add :
       {references, friction, wear_beyond_explicit, mesh_ratios, stiffness_ratios, incompressible, corners, separation,
        tiny_gaps, meshes, orders, huge_increments, complementarity, units, noise, remeshed})
    add(t);
  return t;
}

}  // namespace

const std::vector<Member>& members() {
  static const Table table = all();
  return table;
}

std::string in_units(const std::string& text, const Units& units) {
  const double pressure = units.force / (units.length * units.length);
  const std::array<std::pair<std::string, double>, 5> scales{{{"mm", units.length},
                                                              {"MPa", pressure},
                                                              {"N_per_mm", units.force / units.length},
                                                              {"per_MPa", 1.0 / pressure},
                                                              {"mm3_per_J", 1.0 / pressure}}};
  std::string out;
  std::size_t from = 0;
  for (auto at = text.find('@'); at != std::string::npos; at = text.find('@', from)) {
    const auto open = text.find('(', at), close = text.find(')', at);
    const std::string unit = text.substr(at + 1, open - at - 1);
    double scale = 0.0;
    for (const auto& [name, value] : scales)
      if (name == unit) scale = value;
    if (scale == 0.0) throw std::runtime_error("no such unit: " + unit);
    out += text.substr(from, at - from) + words("%.17g", scale * std::stod(text.substr(open + 1, close - open - 1)));
    from = close + 1;
  }
  return out + text.substr(from);
}

}  // namespace reye::test
