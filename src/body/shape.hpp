#pragma once
#include <memory>

#include "cad/build/drawing.hpp"
#include "mesh/mesh.hpp"

namespace reye::body {

/// The unstressed shape of a worn body: immutable, shared between states.
struct Shape {
  mesh::Mesh mesh;                              ///< on X
  std::shared_ptr<const mesh::Mesh> born;       ///< the mesh as it was generated, before any wear moved it
  std::shared_ptr<const cad::Drawing> drawing;  ///< the curves `born` was made from; null: not known
};

using ShapePtr = std::shared_ptr<const Shape>;

/// A fresh shape on a fresh mesh.
ShapePtr make_shape(mesh::Mesh mesh, std::shared_ptr<const cad::Drawing> drawing = {});

}  // namespace reye::body
