#pragma once
#include <string>
#include <vector>

#include "sim/problem/records.hpp"

/// ParaView files of one state, and the collections that give them their times.
namespace reye::output {

/// All bodies as one unstructured grid (.vtu, inline binary) on their deformed positions x = X + u.
/// Points: displacement, reference_position (X) [mm], stress (XX, YY, XY, ZZ), von_mises [MPa], wear_depth_mm.
/// Cells: body (index in the frame). A rigid body is its outline as polylines, with zero stress.
/// Field data: TimeValue = cycles, body_names, units.
std::string bodies_vtu(const sim::Frame& frame);

/// The meshes of the bodies of a frame on X (.vtu, inline binary), with their boundaries as lines, which `cad` can
/// read. Cells: body, boundary (-1: none). Field data: body_names, boundary_names.
std::string mesh_vtu(const sim::Frame& frame);

/// All contact surfaces as polylines (.vtp) on x. Points: reference_position (X) [mm], pressure_MPa, shear_MPa,
/// slip_mm, status, wear_depth_mm. Cells: surface (index in the frame), side (0 secondary, 1 primary), body (index in
/// the frame), body_on_left (1 where the body lies on the left of the line). Field data as above, and contact_names by
/// surface.
std::string surfaces_vtp(const sim::Frame& frame);

/// Time of each frame: its cycle, or just after the frame before it where the cycle does not grow (as in load steps),
/// so that ParaView shows each one.
std::vector<double> frame_times(const std::vector<double>& cycles);

/// The .pvd collection of frames/<stem>_<six digits>.<ext>.
std::string collection(const std::string& stem, const std::string& ext, const std::vector<double>& times);

/// frames/<stem>_000012.<ext>
std::string frame_file(const std::string& stem, const std::string& ext, std::size_t index);

}  // namespace reye::output
