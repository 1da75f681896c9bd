#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "output/report/drawn_frame.hpp"
#include "output/report/plot.hpp"

/// The part of the plane about one contact, and what is drawn there.
namespace reye::output {

/// A part of the plane [mm].
struct Window {
  Range x, y;

  base::Vec2 centre() const { return {0.5 * (x.low + x.high), 0.5 * (y.low + y.high)}; }
  /// Whether the box of some points meets it.
  bool meets(std::initializer_list<base::Vec2> points) const;
};

/// Which places of the surfaces a window holds.
enum class Held { deformed, stress_free };

/// The window, in the aspect of a figure, of all places of a contact that are under pressure or worn in one of the
/// frames (its whole surfaces without any), `margin` times as wide as they are.
Window contact_window(const std::string& contact, const std::vector<DrawnSurfaces>& frames, Held held, double margin);

/// The round factor (1, 2 or 5 times a power of ten) by which wear of this depth is shown in a window of this height:
/// at most an eighth of it; 1 where it is that deep already.
double magnification(double depth_mm, const Window& window);

/// Per point of the surfaces the unit vector into its body, for points deformed or stress-free.
base::Points inward(const DrawnSurfaces& surfaces, Held held);

/// The bodies of a frame inside the window: von Mises stress in bands between `levels`, outlines above. Wear is shown
/// `factor` times as deep: nodes move into their body with the nearest place of its contact surfaces, less and less
/// down to a third of the window's height.
Moment stressed_bodies(const DrawnFrame& frame, const DrawnSurfaces& surfaces, const Window& window,
                       const std::vector<double>& levels, double factor);

/// The figure that holds such moments: axes, and a scale of stress up to `top`.
Figure stress_figure(const std::string& id, const std::string& title, const Window& window, double top_MPa);

/// Largest von Mises stress at the nodes inside the window [MPa].
double largest_stress(const DrawnFrame& frame, const Window& window);

/// Round levels of stress from zero to at least `top`; from 0 to 1 where that is zero.
std::vector<double> stress_levels(double top_MPa);

/// "×20" as in titles.
std::string times_words(double factor);

}  // namespace reye::output
