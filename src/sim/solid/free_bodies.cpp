#include "sim/solid/free_bodies.hpp"

namespace reye::sim {

std::string free_bodies_in_words(const solver::SolidSystem& system) {
  std::string text;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& body = system.bodies[b];
    const auto motions = system.turning[b] ? body::unheld_motions(*system.turning[b]) : body.free_motions();
    if (motions.empty()) continue;
    text += text.empty() ? "" : "; ";
    text += "body " + body.input().name + " (";
    for (std::size_t k = 0; k < motions.size(); ++k) text += (k > 0 ? ", " : "") + motions[k];
    text += ")";
  }
  return text.empty() ? text
                      : "neither supports nor contact hold what is free to move: " + text +
                            ". Hold these motions, or bring the bodies into contact by an imposed motion first";
}

}  // namespace reye::sim
