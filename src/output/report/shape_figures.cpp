#include "output/report/shape_figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "output/folder/text.hpp"
#include "output/report/contact_zone.hpp"
#include "output/report/profiles.hpp"

namespace reye::output {

namespace {

constexpr double margin_of_shape = 1.4, margin_of_stress = 2.0;  ///< times the width of the scar, or of the contact

/// The lines of one side of a contact, one after the other, worn `factor` times as deep as they are.
Line side_of(const DrawnSurfaces& surfaces, const base::Points& into, const std::string& contact, bool secondary,
             double factor) {
  Line line;
  for (const auto& part : surfaces.lines) {
    if (part.contact != contact || part.secondary != secondary) continue;
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const base::Vec2 at = surfaces.X[i] + (factor - 1.0) * surfaces.wear_depth_mm[i] * into[i];
      line.x.push_back(at.x());
      line.y.push_back(at.y());
    }
    line.x.push_back(NAN);
    line.y.push_back(NAN);
  }
  return line;
}

/// Both sides before (as they were drawn) and after the run.
Figure worn_shape(const ContactData& contact, const DrawnSurfaces& first, const DrawnSurfaces& last,
                  const Window& window, double factor) {
  Figure figure{.x_label = "x, mm", .y_label = "y, mm"};
  figure.x_range = window.x;
  figure.y_range = window.y;
  figure.exact_ranges = true;
  const auto before = inward(first, Held::stress_free), after = inward(last, Held::stress_free);
  for (const bool secondary : {true, false}) {
    Line line = side_of(first, before, contact.name, secondary, 1.0);
    if (secondary) line.label = "before";
    line.colour = "#6a717c";
    line.dashed = true;
    line.width = 1.2;
    figure.lines.push_back(std::move(line));
  }
  for (const bool secondary : {true, false}) {
    Line line = side_of(last, after, contact.name, secondary, factor);
    line.label = secondary ? "secondary side, after" : "primary side, after";
    line.colour = line_colour(secondary ? 0 : 1);
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

void add_shapes(const RunData& run, const ContactData& contact, const DrawnSurfaces& first, const DrawnSurfaces& last,
                std::vector<Figure>& all) {
  const double deepest = deepest_of(contact);
  if (deepest == 0.0) return;
  const Window window = contact_window(contact.name, {last}, Held::stress_free, margin_of_shape);
  const double factor = magnification(deepest, window);
  const auto factors = factor == 1.0 ? std::vector{1.0} : std::vector{1.0, factor};
  for (const double shown : factors) {
    Figure figure = worn_shape(contact, first, last, window, shown);
    figure.id = (shown == 1.0 ? "shape-" : "shape-magnified-") + file_part(contact.name);
    figure.title = title_of(run, contact, "Shape before and after " + rounded(last.cycle, 6) + " cycles, stress-free") +
                   (shown == 1.0 ? ", true to scale" : ", wear " + times_words(shown));
    all.push_back(std::move(figure));
  }
}

/// The last of so many frames in which a contact is under pressure; the last without any.
std::size_t last_pressed(const ContactData& contact, std::size_t count) {
  const SurfaceTable& surface = contact.sides.front();
  const auto& pressure = surface.table.column("pressure_MPa");
  for (std::size_t k = count; k-- > 0;)
    for (std::size_t i = surface.frames[k].begin; i < surface.frames[k].end; ++i)
      if (pressure[i] > 0.0) return k;
  return count - 1;
}

/// A frame with its surfaces.
struct FrameDrawn {
  DrawnSurfaces surfaces;
  DrawnFrame bodies;
};

/// Frames that are read once, however many contacts ask for them.
class Frames {
 public:
  explicit Frames(std::string dir) : dir_(std::move(dir)) {}

  const FrameDrawn& operator[](std::size_t k) {
    const auto known = drawn_.find(k);
    if (known != drawn_.end()) return known->second;
    return drawn_[k] = {read_drawn_surfaces(frame_path(dir_, "surface", "vtp", k)),
                        read_drawn(frame_path(dir_, "bodies", "vtu", k))};
  }

 private:
  std::string dir_;
  std::map<std::size_t, FrameDrawn> drawn_;
};

void add_stress(const RunData& run, const ContactData& contact, const FrameDrawn& drawn, std::vector<Figure>& all) {
  const auto& [surfaces, frame] = drawn;
  const Window window = contact_window(contact.name, {surfaces}, Held::deformed, margin_of_stress);
  const double top = largest_stress(frame, window);
  if (!(top > 0.0)) return;
  Figure figure = stress_figure(
      "stress-" + file_part(contact.name),
      title_of(run, contact, "Von Mises stress at cycle " + rounded(frame.cycle, 6) + ", deformed"), window, top);
  Moment moment = stressed_bodies(frame, surfaces, window, stress_levels(top), 1.0);
  figure.areas = std::move(moment.areas);
  figure.lines = std::move(moment.lines);
  all.push_back(std::move(figure));
}

}  // namespace

std::vector<Figure> shape_figures(const RunData& run, const std::string& dir) {
  std::vector<Figure> all;
  const std::size_t count = frame_count(run, dir);
  if (count == 0) return all;
  const DrawnSurfaces first = read_drawn_surfaces(frame_path(dir, "surface", "vtp", 0));
  Frames frames(dir);
  for (const auto& contact : run.contacts) {
    add_shapes(run, contact, first, frames[count - 1].surfaces, all);
    add_stress(run, contact, frames[last_pressed(contact, count)], all);
  }
  return all;
}

}  // namespace reye::output
