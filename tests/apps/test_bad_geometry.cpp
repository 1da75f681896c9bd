#include "bad_scene.hpp"

using namespace reye;

// A geometry file that is missing, empty, of no use or cannot be read must be refused by its name.
TEST(BadInput, Files) {
  const std::vector<test::BadScene> scenes = {
      {"missing file",
       {{R"("blocks.geo")", R"("none.step")"}},
       "",
       R"(scene.toml:1: geometry = "none.step": no such file)"},
      {"empty file", {{R"("blocks.geo")", R"("empty.geo")"}}, "", R"(scene.toml:1: geometry = "empty.geo": is empty)"},
      {"unsupported format",
       {{R"("blocks.geo")", R"("part.stl")"}},
       "",
       R"(scene.toml:1: geometry = "part.stl": not supported; use .step, .stp, .iges, .igs, .brep, .geo, .msh or .vtu)"},
      {"a folder",
       {{R"("blocks.geo")", R"("folder.step")"}},
       "",
       R"(scene.toml:1: geometry = "folder.step": is not a file)"},
      {"no face",
       {{R"("blocks.geo")", R"("comment.geo")"}},
       "",
       R"(scene.toml:1: geometry = "comment.geo": holds no face)"},
      {"no STEP file at all",
       {{R"("blocks.geo")", R"("garbage.step")"}},
       "",
       R"(scene.toml:1: geometry = "garbage.step": is not a STEP file: it must begin with ISO-10303-21)"},
      {"unknown word",
       {{R"("blocks.geo")", R"("garbage.geo")"}},
       "",
       R"(scene.toml:1: geometry = "garbage.geo": line 1: garbage is neither a command that Reye lets a script use nor a variable that it sets; take it out, or run with --trust-geometry if you trust the file)"},
      {"syntax error in known words",
       {{R"("blocks.geo")", R"("syntax.geo")"}},
       "",
       R"(scene.toml:1: geometry = "syntax.geo": gmsh cannot read it: 'FOLDER/syntax.geo', line 1: syntax error (=))"},
      {"two bad files",
       {{R"("blocks.geo")", R"("comment.geo", "garbage.step")"}},
       "",
       R"(scene.toml:1: geometry = "comment.geo": holds no face)"
       "\n"
       R"(scene.toml:1: geometry = "garbage.step": is not a STEP file: it must begin with ISO-10303-21)"},
      {"a solid",
       {{R"("blocks.geo")", R"("solid.step")"}},
       "",
       R"(scene.toml:1: geometry = "solid.step": holds a solid; bodies are planar faces: cut it by section = { point_mm = [...], normal = [...] })"},
      {"a section that misses the solid",
       {{R"("blocks.geo"])", R"("solid.step"]
section = { point_mm = [0.0, 0.0, 3.0], normal = [0.0, 0.0, -2.0] })"}},
       "",
       R"(scene.toml:2: section.point_mm = [0, 0, 3]: the plane, at -3 mm along its normal, misses every solid of solid.step: 'Open CASCADE STEP translator 7.6 1' from -1 to 0)"},
      {"faces across the section",
       {{R"("blocks.geo"])", R"("blocks.geo"]
section = { point_mm = [0.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] })"}},
       "",
       R"(scene.toml:1: geometry = "blocks.geo": face 'slider': lies in a plane that is not parallel to the section)"
       "\n"
       R"(scene.toml:1: geometry = "blocks.geo": face 'base': lies in a plane that is not parallel to the section)"},
      {"mixed cells",
       {{R"("blocks.geo")", R"("mixed.msh")"}},
       "",
       R"(scene.toml:1: geometry = "mixed.msh": the mesh must be all triangles of 3 or 6 nodes or all quadrilaterals of 4, 8 or 9 nodes)"},
      {"curved face",
       {{R"("blocks.geo")", R"("ball.geo")"}},
       "",
       R"(scene.toml:1: geometry = "ball.geo": face 1: a body must be a planar face)"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}

// A name or selector that fits nothing or two things must be refused with what there is, and geometry outside of the
// rules with its place.
TEST(BadInput, BodiesAndBoundaries) {
  const std::vector<test::BadScene> scenes = {
      {"name of no face",
       {{R"([body.slider])", R"([body.slidr])"}},
       "",
       R"(scene.toml:7: body.slidr: has neither 'at' nor 'name', and its own name is that of no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"},
      {"label of no face",
       {{R"([body.slider])", R"([body.slider]
name = "sldr")"}},
       "",
       R"(scene.toml:8: body.slider.name = "sldr": is the name of no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"},
      {"point in no face",
       {{R"([body.slider])", R"([body.slider]
at = [9.0, 9.0])"}},
       "",
       R"(scene.toml:8: body.slider.at = [9, 9]: the point lies in no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"},
      {"point in two faces",
       {{R"("blocks.geo")", R"("twice.geo")"}, {R"([body.slider])", R"([body.slider]
at = [1.5, 0.5])"}},
       "",
       R"(scene.toml:8: body.slider.at = [1.5, 0.5]: the point lies in more than one face: unnamed in [1, 0, 3, 1], unnamed in [1, 0, 3, 1])"},
      {"face chosen twice",
       {{R"([body.slider])", R"([body.slider]
at = [0.5, -0.5])"}},
       "",
       R"(scene.toml:12: body.base: selects the same face as body 'slider': 'base' in [0, -1, 4, 0])"},
      {"unknown secondary side",
       {{R"(secondary = "slider_bottom")", R"(secondary = "slider_botom")"}},
       "",
       R"(scene.toml:16: contact.pad.secondary = "slider_botom": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"},
      {"support on an edge of two bodies",
       {{R"(edge     = "slider_top")", R"(edge = "left")"}},
       "",
       R"(scene.toml:22: support.holder.edge = "left": more than one body has a boundary of this name; write body.name)"},
      {"primary side on two bodies",
       {{R"(["base_top"])", R"(["base_top", "left"])"}},
       "",
       R"(scene.toml:17: contact.pad.primary = "left": more than one body has a boundary of this name; write body.name)"},
      {"unknown edge of a support",
       {{R"("slider_top")", R"("slider_tops")"}},
       "",
       R"(scene.toml:22: support.holder.edge = "slider_tops": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"},
      {"unknown edge of a load",
       {},
       R"(
[load.side]
edge = "right"
pressure_MPa = 1.0
)",
       R"(scene.toml:41: load.side.edge = "right": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"},
      {"box around nothing",
       {},
       R"(
[boundary]
box = { body = "base", box_mm = [7.0, 7.0, 8.0, 8.0] }
)",
       R"(scene.toml:41: boundary.box.box_mm = [7, 7, 8, 8]: matches no edge of body 'base', which has: line [0, -1] to [4, -1], line [4, -1] to [4, 0], line [4, 0] to [0, 0], line [0, 0] to [0, -1])"},
      {"no such kind of edge",
       {},
       R"(
[boundary]
round = { body = "base", type = "circle" }
)",
       R"(scene.toml:41: boundary.round.type = "circle": matches no edge of body 'base', which has: line [0, -1] to [4, -1], line [4, -1] to [4, 0], line [4, 0] to [0, 0], line [0, 0] to [0, -1])"},
      {"as near to two edges",
       {},
       R"(
[boundary]
near = { body = "slider", nearest_mm = [3.5, 1.5] }
)",
       R"(scene.toml:41: boundary.near.nearest_mm = [3.5, 1.5]: is equally near to: line [3, 0] to [3, 1], line [3, 1] to [1, 1])"},
      {"profile longer than its boundary",
       {},
       R"(
[boundary]
face = { body = "slider", nearest_mm = [2.0, 0.0], profile = "long.csv" }
)",
       R"(scene.toml:41: boundary.face.profile = "long.csv": reaches to arc length 3 mm; the boundary is 2 mm long)"},
      {"profile through the body",
       {},
       R"(
[boundary]
face = { body = "slider", nearest_mm = [2.0, 0.0], profile = "deep.csv" }
)",
       R"(scene.toml:41: boundary.face.profile = "deep.csv": makes the outline cross itself near [1.80652, 1])"},
      {"profile with a step",
       {},
       R"(
[boundary]
face = { body = "slider", nearest_mm = [2.0, 0.0], profile = "ends.csv" }
)",
       R"(scene.toml:41: boundary.face.profile = "ends.csv": the height at arc length 0.5 mm, where it ends within the boundary, is 0.1 mm; it must be 0 there)"},
      {"interval beyond the edge",
       {},
       R"(
[load.top]
edge = "slider_top"
pressure_MPa = 1.0
interval_mm = [5.0, 6.0]
)",
       R"(scene.toml:43: load.top.interval_mm: meets no part of the edge)"},
      {"negative radius",
       {{R"(geometry)", R"(analysis = "axisymmetric"
geometry)"},
        {R"("blocks.geo")", R"("left.geo")"},
        {R"(force_N_per_mm)", R"(force_N)"}},
       "",
       R"(scene.toml:8: body.slider: reaches x = -3; in an axisymmetric scene x is the radius and nothing lies at x < 0)"},
      {"fine zone in the void",
       {{R"(wear )", R"(fine_zone = { centre_mm = [50.0, 50.0], half_width_mm = 0.1, depth_mm = 0.1, size_mm = 0.01 }
wear )"}},
       "",
       R"(scene.toml:19: contact.pad.fine_zone.centre_mm = [50, 50]: no edge of a body passes through the fine zone)"},
      {"ten thousand million nodes",
       {{R"(wear )", R"(fine_zone = { centre_mm = [2.0, 0.0], half_width_mm = 1.0, depth_mm = 0.5, size_mm = 1e-5 }
wear )"}},
       "",
       R"(scene.toml:7: body.slider: would need about 1.00013e+10 nodes (at most 1e+06): raise the fine zone's size_mm or mesh.far_size_mm)"
       "\n"
       R"(scene.toml:11: body.base: would need about 1.00013e+10 nodes (at most 1e+06): raise the fine zone's size_mm or mesh.far_size_mm)"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}
