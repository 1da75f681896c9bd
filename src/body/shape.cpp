#include "body/shape.hpp"

#include <utility>

namespace reye::body {

ShapePtr make_shape(mesh::Mesh mesh, std::shared_ptr<const cad::Drawing> drawing) {
  auto born = std::make_shared<const mesh::Mesh>(mesh);
  return std::make_shared<const Shape>(Shape{std::move(mesh), std::move(born), std::move(drawing)});
}

}  // namespace reye::body
