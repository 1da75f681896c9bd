#pragma once
#include <string>
#include <vector>

#include "output/report/plot.hpp"
#include "output/report/run_data.hpp"

/// Surface tables as lines of a figure.
namespace reye::output {

/// A unit that keeps axis labels short.
struct Unit {
  double factor;  ///< from mm
  std::string name;
};

Unit length_unit(double largest_mm);

/// The largest size of the finite values; 0 without any.
double largest(const std::vector<double>& values);

/// The largest depth on either side in all frames [mm].
double deepest_of(const ContactData& contact);

/// `what`, with the contact's name where there are several.
std::string title_of(const RunData& run, const ContactData& contact, const std::string& what);

/// The origin of positions on a surface: arc length about the centroid of the last pressure (of the last depth
/// when nothing presses), so that both sides and all cycles lie over each other. A ring is cut opposite to its centre,
/// wherever its table begins.
double centre_of(const SurfaceTable& surface);

/// The part of the surface that is ever in contact or worn, with a margin; otherwise the whole surface.
Range active_range(const SurfaceTable& surface, double centre);

/// A column of one frame against the position; between two chains the line is broken.
Line column_line(const SurfaceTable& surface, const FrameRows& rows, const std::string& column, double factor,
                 double centre);

/// At most `most` (>= 2) of the numbers from 0 to count - 1, evenly spread, first and last among them.
std::vector<std::size_t> evenly_chosen(std::size_t count, std::size_t most);

}  // namespace reye::output
