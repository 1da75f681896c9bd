#pragma once
#include <string>
#include <vector>

#include "body/operator.hpp"

/// Rigid motions that supports and loads leave free.
namespace reye::body {

/// The rigid motions of the body that nothing holds and nothing loads, in words ("translation along x",
/// "rotation"); empty when the body is well posed. A motion left free by the supports is accepted when the
/// body has a contact and either friction acts there or some load or loaded support does work on the motion.
std::vector<std::string> unheld_motions(const mesh::Mesh& mesh, const BodyInput& input, bool friction);

/// A body as its mesh and its supports.
struct HeldBody {
  const mesh::Mesh* mesh = nullptr;
  const std::vector<Support>* supports = nullptr;
};

/// Rigid motions that nothing holds of bodies that touch one another, moved as one: contacts among them hold none of
/// these motions, and loads do not hold them either.
std::vector<std::string> unheld_together(const std::vector<HeldBody>& bodies, bool axisymmetric);

}  // namespace reye::body
