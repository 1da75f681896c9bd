#include "cad/part/select.hpp"

#include <algorithm>
#include <limits>

#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

constexpr double box_tolerance = 1e-6;  // mm; gmsh and CAD round their boxes

std::string list(const std::vector<std::string>& items) {
  constexpr std::size_t shown = 12;
  std::string all;
  for (std::size_t i = 0; i < std::min(items.size(), shown); ++i) all += (i ? ", " : "") + items[i];
  if (items.size() > shown) all += " and " + std::to_string(items.size() - shown) + " more";
  return all;
}

std::string list_of(const std::vector<Part>& parts, const std::vector<int>& which) {
  std::vector<std::string> items;
  for (int k : which) items.push_back(describe(parts[k]));
  return list(items);
}

/// The parts one body's selector matches, with the issue to raise if they are not exactly one.
std::pair<std::vector<int>, base::Issue> matches(const std::vector<Part>& parts, const BodyOptions& body) {
  const std::string key = "body." + body.name;
  std::vector<int> all, found;
  for (int k = 0; k < static_cast<int>(parts.size()); ++k) {
    all.push_back(k);
    const bool inside = !body.at || contains(parts[k], *body.at);
    const bool named = body.label ? parts[k].label == *body.label : body.at || parts[k].label == body.name;
    if (inside && named) found.push_back(k);
  }
  base::Issue issue{key, "", ""};
  if (body.at)
    issue = {key + ".at", text(*body.at), "the point lies in"};
  else if (body.label)
    issue = {key + ".name", "\"" + *body.label + "\"", "is the name of"};
  else
    issue.rule = "has neither 'at' nor 'name', and its own name is that of";
  issue.rule +=
      found.empty() ? " no face; there are: " + list_of(parts, all) : " more than one face: " + list_of(parts, found);
  return {found, issue};
}

std::string list_edges(const Part& part) {
  std::vector<std::string> items;
  for (const Loop& loop : part.loops)
    for (const Edge& edge : loop) items.push_back(describe(edge));
  return list(items);
}

bool inside(const std::array<double, 4>& inner, const std::array<double, 4>& outer) {
  return inner[0] >= outer[0] - box_tolerance && inner[1] >= outer[1] - box_tolerance &&
         inner[2] <= outer[2] + box_tolerance && inner[3] <= outer[3] + box_tolerance;
}

/// Keeps the chosen edges for which `belongs` holds; says whether any is left.
template <class Predicate>
bool narrow(const Part& part, EdgeChoice& choice, Predicate belongs) {
  bool any = false;
  for (std::size_t loop = 0; loop < part.loops.size(); ++loop)
    for (std::size_t k = 0; k < part.loops[loop].size(); ++k) {
      choice[loop][k] = choice[loop][k] && belongs(part.loops[loop][k]);
      any = any || choice[loop][k];
    }
  return any;
}

EdgeChoice all_edges(const Part& part, bool value) {
  EdgeChoice choice;
  for (const Loop& loop : part.loops) choice.emplace_back(loop.size(), value);
  return choice;
}

/// Leaves the one chosen edge nearest to p; returns the edges that share the smallest distance if more than one.
std::vector<std::string> keep_nearest(const Part& part, EdgeChoice& choice, const Vec2& p) {
  double smallest = std::numeric_limits<double>::infinity();
  narrow(part, choice, [&](const Edge& edge) {
    smallest = std::min(smallest, foot_on(edge, p).distance);
    return true;
  });
  std::vector<std::string> nearest;
  narrow(part, choice, [&](const Edge& edge) {
    const bool belongs = foot_on(edge, p).distance <= smallest + box_tolerance;
    if (belongs) nearest.push_back(describe(edge));
    return belongs;
  });
  return nearest;
}

}  // namespace

std::vector<int> select_parts(const std::vector<Part>& parts, const std::vector<BodyOptions>& bodies,
                              std::vector<base::Issue>& issues) {
  std::vector<int> chosen;
  for (const BodyOptions& body : bodies) {
    const auto [found, issue] = matches(parts, body);
    if (found.size() != 1) {
      issues.push_back(issue);
      chosen.push_back(-1);
      continue;
    }
    const auto taken = std::find(chosen.begin(), chosen.end(), found[0]);
    if (taken != chosen.end())
      issues.push_back({issue.key, issue.value,
                        "selects the same face as body '" + bodies[taken - chosen.begin()].name +
                            "': " + describe(parts[found[0]])});
    chosen.push_back(found[0]);
  }
  return chosen;
}

std::optional<EdgeChoice> select_edges(const Part& part, const BoundaryOptions& boundary,
                                       std::vector<base::Issue>& issues) {
  const std::string key = "boundary." + boundary.name;
  EdgeChoice choice = all_edges(part, true);
  const auto nothing = [&](const std::string& selector, const std::string& value) {
    issues.push_back(
        {key + selector, value, "matches no edge of body '" + boundary.body + "', which has: " + list_edges(part)});
    return std::nullopt;
  };
  const bool bare = !boundary.box_mm && !boundary.type && !boundary.nearest_mm;
  const auto is_named = [&](const Edge& edge) { return edge.names.contains(boundary.name); };
  if (EdgeChoice physical = choice; bare && narrow(part, physical, is_named)) return physical;
  if (boundary.box_mm &&
      !narrow(part, choice, [&](const Edge& edge) { return inside(bounding_box(edge), *boundary.box_mm); }))
    return nothing(".box_mm", text(*boundary.box_mm));
  if (boundary.type && !narrow(part, choice, [&](const Edge& edge) { return to_string(edge.type) == *boundary.type; }))
    return nothing(".type", "\"" + *boundary.type + "\"");
  if (!boundary.nearest_mm) return choice;
  const std::vector<std::string> nearest = keep_nearest(part, choice, *boundary.nearest_mm);
  if (nearest.size() == 1) return choice;
  issues.push_back({key + ".nearest_mm", text(*boundary.nearest_mm), "is equally near to: " + list(nearest)});
  return std::nullopt;
}

std::map<std::string, EdgeChoice> named_edges(const Part& part) {
  std::map<std::string, EdgeChoice> named;
  for (std::size_t loop = 0; loop < part.loops.size(); ++loop)
    for (std::size_t k = 0; k < part.loops[loop].size(); ++k)
      for (const std::string& name : part.loops[loop][k].names)
        named.try_emplace(name, all_edges(part, false)).first->second[loop][k] = true;
  return named;
}

}  // namespace reye::cad
