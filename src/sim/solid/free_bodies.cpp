#include "sim/solid/free_bodies.hpp"

#include <algorithm>

namespace reye::sim {

namespace {

bool has_springs(const body::SolidBody& body) {
  const auto pulls = [](const body::Motion& motion) { return motion.stiffness > 0.0; };
  return std::any_of(body.input().supports.begin(), body.input().supports.end(), [&](const auto& support) {
    return std::any_of(support.along.begin(), support.along.end(), pulls) ||
           std::any_of(support.about.begin(), support.about.end(), pulls);
  });
}

}  // namespace

std::string free_bodies_in_words(const solver::SolidSystem& system) {
  std::string text, springs;
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const auto& body = system.bodies[b];
    const auto motions = system.turning[b] ? body::unheld_motions(*system.turning[b]) : body.free_motions();
    if (motions.empty()) continue;
    if (has_springs(body)) springs = body.input().name;
    text += text.empty() ? "" : "; ";
    text += "body " + body.input().name + " (";
    for (std::size_t k = 0; k < motions.size(); ++k) text += (k > 0 ? ", " : "") + motions[k];
    text += ")";
  }
  if (text.empty()) return text;
  text = "neither supports nor contact hold what is free to move: " + text +
         ". Hold these motions, or bring the bodies into contact by an imposed motion first";
  if (!springs.empty())
    text +=
        ". Springs hold body " + springs +
        ": where it fits closely they must be stiffer than the load over the clearance, else it slides out of reach";
  return text;
}

}  // namespace reye::sim
