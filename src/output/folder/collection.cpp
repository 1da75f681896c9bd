#include <algorithm>
#include <cmath>
#include <limits>

#include "output/folder/text.hpp"
#include "output/folder/vtk_frames.hpp"

namespace reye::output {

std::vector<double> frame_times(const std::vector<double>& cycles) {
  std::vector<double> times;
  for (const double cycle : cycles) {
    double time = cycle;
    if (!times.empty() && cycle <= times.back()) {
      const double last = times.back();
      time = last + std::max(1e-6, 8.0 * std::abs(last) * std::numeric_limits<double>::epsilon());
    }
    times.push_back(time);
  }
  return times;
}

std::string frame_file(const std::string& stem, const std::string& ext, std::size_t index) {
  const std::string digits = std::to_string(index);
  return "frames/" + stem + '_' + std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits + '.' + ext;
}

std::string collection(const std::string& stem, const std::string& ext, const std::vector<double>& times) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (std::size_t i = 0; i < times.size(); ++i)
    xml += "    <DataSet timestep=\"" + number(times[i]) + "\" group=\"\" part=\"0\" file=\"" +
           frame_file(stem, ext, i) + "\"/>\n";
  return xml + "  </Collection>\n</VTKFile>\n";
}

}  // namespace reye::output
