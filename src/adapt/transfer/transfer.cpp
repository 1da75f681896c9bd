#include "adapt/transfer/transfer.hpp"

#include <cassert>
#include <sstream>

#include "adapt/transfer/locate.hpp"

namespace reye::adapt {

namespace {

std::vector<Locator::Place> places_of(const mesh::Mesh& from, const mesh::Mesh& to) {
  const Locator locator(from);
  std::vector<Locator::Place> places;
  places.reserve(to.X.size());
  for (const Vec2& x : to.X) places.push_back(locator.find(x));
  return places;
}

std::string outside(const mesh::Mesh& to, int node, double distance, double most_distance) {
  std::ostringstream text;
  text << "node " << node << " of the new mesh at (" << to.X[node].x() << ", " << to.X[node].y() << ") mm lies "
       << distance << " mm outside the old mesh, more than " << most_distance << " mm";
  return text.str();
}

Field interpolated(const mesh::Mesh& from, const Field& field, const std::vector<Locator::Place>& places) {
  assert(field.values.size() == from.X.size() * field.components);
  Field result{field.name, field.components, std::vector<double>(places.size() * field.components, 0.0)};
  for (std::size_t i = 0; i < places.size(); ++i)
    for (int a = 0; a < mesh::nodes_per_cell(from.kind); ++a) {
      const double w = places[i].weights[a];
      if (w == 0.0) continue;
      const std::size_t node = from.cells[places[i].cell][a];
      for (int c = 0; c < field.components; ++c)
        result.values[i * field.components + c] += w * field.values[node * field.components + c];
    }
  return result;
}

}  // namespace

Transferred transfer(const mesh::Mesh& from, const std::vector<Field>& fields, const mesh::Mesh& to,
                     double most_distance) {
  Transferred result;
  if (fields.empty()) return result;
  const auto places = places_of(from, to);
  int farthest = -1;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].distance > result.largest_distance) {
      result.largest_distance = places[i].distance;
      farthest = static_cast<int>(i);
    }
  if (farthest >= 0 && result.largest_distance > most_distance) {
    result.failure = outside(to, farthest, result.largest_distance, most_distance);
    return result;
  }
  for (const auto& field : fields) result.fields.push_back(interpolated(from, field, places));
  return result;
}

}  // namespace reye::adapt
