#pragma once
#include "scene/scene.hpp"

/// The order of elements and the multipliers' basis, chosen by the contact where the scene leaves them open.
///
/// A contact that only forces drive cannot slide as a whole, since the force would accelerate its body. It slips in
/// part, and as wear empties the annulus around the stick zone, pressure and shear become singular at its edge.
/// Elements of first order make a sheared edge up to 1.2 times as strong as a pressed one, and sticking recedes
/// (results/partial_slip_life); second order with linear multipliers has a ratio of 0.99. A prescribed motion may slide
/// a body as a whole: there first order stays.
namespace reye::scene {

/// The choice for one contact where the scene leaves it open.
struct ElementChoice {
  std::size_t contact = 0;                ///< its place in the scene
  std::vector<std::string> second_order;  ///< bodies; none where the scene gives the order of one
  bool linear = false;                    ///< multipliers
};

std::vector<ElementChoice> element_choices(const Scene& scene);

/// Applies the element choices to the scene.
void choose_elements(Scene& scene);

/// The choice and its reason, in words.
std::string in_words(const Scene& scene, const ElementChoice& choice);

}  // namespace reye::scene
