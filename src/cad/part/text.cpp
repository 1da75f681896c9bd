#include "cad/part/text.hpp"

#include <sstream>

namespace reye::cad {

std::string text(double x) {
  std::ostringstream out;
  out << (x == 0.0 ? 0.0 : x);  // avoids minus zero
  return out.str();
}

std::string text(const base::Vec2& p) { return "[" + text(p.x()) + ", " + text(p.y()) + "]"; }

std::string text(const std::array<double, 4>& box) {
  return "[" + text(box[0]) + ", " + text(box[1]) + ", " + text(box[2]) + ", " + text(box[3]) + "]";
}

}  // namespace reye::cad
