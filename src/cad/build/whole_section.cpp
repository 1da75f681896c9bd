#include "cad/build/whole_section.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "cad/part/axis_pieces.hpp"
#include "cad/part/half.hpp"
#include "cad/part/mirror.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

using base::Issue;

/// The boundaries of a plan on its half; those that would lose edges whose mirror images they lack are refused or
/// dropped.
void halve_boundaries(BodyPlan& plan, const Half& half, const std::vector<BoundaryOptions>& all,
                      std::vector<Issue>& issues) {
  std::map<std::string, EdgeChoice> kept;
  for (const auto& [name, choice] : plan.boundaries) {
    const std::string lonely = chosen_on_one_side(*plan.part, choice);
    const auto asked = std::find_if(all.begin(), all.end(), [&](const BoundaryOptions& b) {
      return b.name == name && b.body == plan.options->name;
    });
    if (asked != all.end() && !lonely.empty())
      issues.push_back({"boundary." + name, "",
                        "selects the " + lonely +
                            " at x < 0, which is cut away, and not its mirror image: of the section of body '" +
                            plan.options->name + "' the half x >= 0 is taken; select the edge at x > 0, or both"});
    else if (asked != all.end() && asked->profile)
      issues.push_back({"boundary." + name + ".profile", "\"" + asked->profile->file + "\"",
                        "lies on a section of which the half x >= 0 is taken; draw that half alone, so that arc length "
                        "counts on it"});
    else if (!lonely.empty())
      plan.cut_off.insert(name);
    else
      kept[name] = on_half(choice, half);
  }
  plan.boundaries = std::move(kept);
}

}  // namespace

void leave_out_mirror_images(std::vector<Part>& parts) {
  const auto on_left = [](const Part& part) {
    return !part.mesh && !crosses_axis(part) && bounding_box(part)[0] < -axis_width(part);
  };
  const auto has_image = [&](const Part& left) {
    return on_left(left) && std::any_of(parts.begin(), parts.end(), [&](const Part& right) {
             return !right.mesh && right.label == left.label && right.file == left.file && !on_left(right) &&
                    are_mirrored(left, right);
           });
  };
  std::vector<Part> kept;
  for (const Part& part : parts)
    if (!has_image(part)) kept.push_back(part);
  parts = std::move(kept);
}

void tell_of_the_half(const std::vector<BodyOptions>& bodies, std::vector<Issue>& issues) {
  for (const BodyOptions& body : bodies)
    for (Issue& issue : issues)
      if (body.at && body.at->x() < 0.0 && issue.key == "body." + body.name + ".at")
        issue.rule +=
            "; an axisymmetric scene takes what lies at x >= 0: give " + text(Vec2(-body.at->x(), body.at->y()));
}

void take_halves(Plans& plans, const GeometryOptions& options, std::vector<Issue>& issues) {
  for (BodyPlan& plan : plans.bodies) {
    if (!plan.part || plan.part->mesh || !crosses_axis(*plan.part)) continue;
    const std::string key = "body." + plan.options->name,
                      mend = "; draw it symmetric about x = 0, or its half x >= 0 alone";
    try {
      if (const std::string differ = asymmetry(*plan.part); !differ.empty()) {
        issues.push_back(
            {key, "", "lies on both sides of the axis and is not mirror-symmetric about it: " + differ + mend});
        continue;
      }
      Half half = half_of(*plan.part);
      halve_boundaries(plan, half, options.boundaries, issues);
      plans.parts[plan.part - plans.parts.data()] = std::move(half.part);
      plan.halved = true;
    } catch (const base::MeshError& error) {
      issues.push_back(
          {key, "", "lies on both sides of the axis and cannot be cut along it: " + std::string(error.what()) + mend});
    }
  }
}

}  // namespace reye::cad
