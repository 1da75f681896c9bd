#include "scene/build.hpp"

namespace reye::scene {

namespace {

/// Adds one part: all parts of a motion impose it, or all of them load it.
void add_part(const Entry& part, const MotionKeys& keys, body::Motion& motion, Issues& issues) {
  if (part.given(keys.spring) && !part.given(keys.moved) && !part.given(keys.loaded)) return;
  if (!exactly_one(part, {keys.moved, keys.loaded}, issues)) return;
  const bool moved = part.given(keys.moved), far_end = moved && motion.stiffness != 0.0;
  const auto drive = moved && !far_end ? body::Drive::moved : body::Drive::loaded;
  const auto key = moved ? keys.moved : keys.loaded;
  if (motion.drive != body::Drive::free && motion.drive != drive)
    return refuse(part, {key},
                  "does not go with the " + std::string(moved ? keys.loaded : keys.moved) +
                      " of the parts before it: a "
                      "motion is imposed, or a force leaves it to the equations",
                  issues);
  motion.drive = drive;
  motion.parts.push_back({part.number(key) * (far_end ? motion.stiffness : 1.0), part.text("history")});
}

/// The spring of a motion, in the one of its parts that has it.
void add_spring(const std::vector<Entry>& parts, const MotionKeys& keys, body::Motion& motion, Issues& issues) {
  for (const auto& part : parts) {
    if (!part.given(keys.spring)) continue;
    if (motion.stiffness != 0.0)
      refuse(part, {keys.spring}, "is the second spring of this motion; write one, with the sum of both", issues);
    motion.stiffness = part.number(keys.spring);
    motion.drive = body::Drive::loaded;
  }
}

}  // namespace

body::Motion motion_of(const std::vector<Entry>& parts, const MotionKeys& keys, Issues& issues) {
  body::Motion motion;
  add_spring(parts, keys, motion, issues);
  for (const auto& part : parts) add_part(part, keys, motion, issues);
  return motion;
}

namespace {

struct PlaneKeys {
  MotionKeys own;
  std::vector<std::string_view> other;  ///< those of the other kind of problem, force and spring
};

PlaneKeys plane_keys_of(std::string_view motion, base::Analysis analysis) {
  if (motion == "rotation") return {{"motion_rad", "moment_N_mm_per_mm", "spring_N_mm_per_mm"}, {}};
  if (analysis == base::Analysis::axisymmetric)
    return {{"motion_mm", "force_N", "spring_N_per_mm"}, {"force_N_per_mm", "spring_N_per_mm2"}};
  return {{"motion_mm", "force_N_per_mm", "spring_N_per_mm2"}, {"force_N", "spring_N_per_mm"}};
}

/// Whether a part has keys of the other kind of problem; they are refused.
bool of_other_problem(const Entry& part, const PlaneKeys& keys, base::Analysis analysis, Issues& issues) {
  bool found = false;
  for (const auto other : keys.other) {
    if (!part.given(other)) continue;
    found = true;
    refuse(part, {other}, takes_instead(analysis, other.starts_with("force") ? keys.own.loaded : keys.own.spring),
           issues);
  }
  return found;
}

body::Motion plane_motion_of(const Entry& support, std::string_view name, base::Analysis analysis, Issues& issues) {
  auto parts = support.parts(name);
  if (parts.empty()) return {.drive = support.text(name) == "fixed" ? body::Drive::fixed : body::Drive::free};
  if (name == "rotation" && analysis == base::Analysis::axisymmetric) {
    issues.push_back({support.key(name), "", "must be \"fixed\" or \"free\" in an axisymmetric scene"});
    return {};
  }
  const auto keys = plane_keys_of(name, analysis);
  Issues others;
  std::erase_if(parts, [&](const Entry& part) { return of_other_problem(part, keys, analysis, others); });
  const auto motion = motion_of(parts, keys.own, issues);
  issues.insert(issues.end(), others.begin(), others.end());
  return motion;
}

bool loaded(const body::Support& support) {
  return support.x.drive == body::Drive::loaded || support.y.drive == body::Drive::loaded ||
         support.rotation.drive == body::Drive::loaded;
}

void check_axes(const Entry& entry, const body::Support& support, Issues& issues) {
  if (!support.edge_axes) return;
  refuse(entry, {"x", "y"}, "does not go with tangent and normal", issues);
  refuse(entry, {"angle_deg"}, "tangent and normal follow the edge", issues);
  refuse(entry, {"point_mm"}, "a point has no tangent and normal; use angle_deg", issues);
}

void check_rigid(const Entry& entry, const body::Support& support, Issues& issues) {
  if (support.point_mm) {
    refuse(entry, {"rotation"}, "a point does not rotate", issues);
    refuse(entry, {"rigid"}, "a point is no edge", issues);
  } else if (!support.rigid) {
    refuse(entry, {"rotation"}, "needs a rigid edge", issues);
    const bool sprung = support.x.stiffness > 0.0 || support.y.stiffness > 0.0;
    if (loaded(support))
      issues.push_back(
          {entry.key("rigid"), entry.written("rigid"),
           sprung ? "a spring needs a rigid edge" : "a force or moment needs a rigid edge; or use [load]"});
  }
  if (!support.point_mm) refuse(entry, {"body"}, "an edge has its own body", issues);
}

body::Support support_of(const Entry& entry, base::Analysis analysis, Issues& issues) {
  body::Support support;
  support.name = entry.name();
  support.edge = entry.text("edge");
  support.point_mm = entry.pair("point_mm");
  support.body = entry.text("body");
  support.angle_deg = entry.number("angle_deg");
  support.edge_axes = entry.given("tangent") || entry.given("normal");
  support.x = plane_motion_of(entry, support.edge_axes ? "tangent" : "x", analysis, issues);
  support.y = plane_motion_of(entry, support.edge_axes ? "normal" : "y", analysis, issues);
  support.rotation = plane_motion_of(entry, "rotation", analysis, issues);
  const bool by_default = !support.point_mm && (entry.given("rotation") || loaded(support));
  support.rigid = entry.maybe_flag("rigid").value_or(by_default);
  return support;
}

}  // namespace

std::vector<body::Support> supports_of(const Entry& root, Issues& issues) {
  std::vector<body::Support> supports;
  const auto analysis = analysis_of(root);
  for (const auto& entry : root.all("support")) {
    supports.push_back(support_of(entry, analysis, issues));
    if (!exactly_one(entry, {"edge", "point_mm"}, issues)) continue;
    check_axes(entry, supports.back(), issues);
    check_rigid(entry, supports.back(), issues);
    if (!entry.given("x") && !entry.given("y") && !entry.given("tangent") && !entry.given("normal") &&
        !entry.given("rotation"))
      issues.push_back({entry.key(), "", "names no motion: x, y, tangent, normal or rotation"});
  }
  return supports;
}

}  // namespace reye::scene
