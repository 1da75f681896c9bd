#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cad/part/plane_face.hpp"
#include "output/export/worn_bodies.hpp"

/// Outlines of plane and axisymmetric bodies as texts of files.
namespace reye::output {

/// Begins the first line of every export, by which a former one is recognised.
inline constexpr const char* export_mark = "reye export";

/// Names of contact sides ("pad secondary") by body and place of a node.
using SideNames = std::map<std::pair<int, std::pair<double, double>>, std::string>;

/// The sides of the contacts in a .vtp that `surfaces_vtp` made.
SideNames side_names(const std::string& path);

/// A row per node of the outlines, loop after loop, each closed by its first node: body, loop (0 is the outer one,
/// counter-clockwise), x or r, y, depth, side of a contact. `note` is a comment before it.
std::string outline_csv(const std::vector<WornBody>& bodies, const SideNames& sides, bool axisymmetric,
                        const std::string& note);

/// DXF of AutoCAD R12: a closed polyline per loop through all nodes of the outline, a layer per body.
std::string outline_dxf(const std::vector<WornBody>& bodies, const std::string& note);

/// Faces for STEP; edges of second order stay curves.
std::vector<cad::PlaneFace> faces_of(const std::vector<WornBody>& bodies);

}  // namespace reye::output
