#pragma once

namespace reye::test {

/// The example that shows the whole grammar: fretting, cylinder on flat (McColl et al. 2004).
inline constexpr const char* example = R"(title    = "Cylinder on flat, fretting, McColl et al. 2004, 185 N on 10 mm"
analysis = "plane_strain"                    # plane_strain | plane_stress | axisymmetric (r = x >= 0, axis y)
geometry = ["cylinder_on_flat.step"]         # one file or several, in mm; paths count from this file

[material.steel]
law   = "linear_elastic"
E_MPa = 200e3
nu    = 0.3

[body.cylinder]
at       = [0.0, 3.0]                        # a point inside; or name = "..." (STEP product, physical surface)
material = "steel"
mesh     = { element = "quad", far_size_mm = 0.8 }

[body.flat]
at       = [0.0, -3.0]
material = "steel"
mesh     = { element = "quad", far_size_mm = 0.8 }

[boundary]                                   # names for edges; physical curves of .geo and .msh need no line here
top    = { body = "cylinder", box_mm = [-6.1, 5.9, 6.1, 6.1] }
round  = { body = "cylinder", type = "circle" }
face   = { body = "flat", nearest_mm = [0.0, 0.0] }
bottom = { body = "flat", box_mm = [-6.1, -6.1, 6.1, -5.9] }

[contact.pad]
secondary = "face"                           # carries the multipliers
primary   = ["round"]
friction  = 0.9
wear      = { law = "energy", secondary_mm3_per_J = 3.222e-5, primary_mm3_per_J = 2.111e-5 }
fine_zone = { centre_mm = [0.0, 0.0], half_width_mm = 0.5, depth_mm = 0.2, size_mm = 0.010 }

[support.holder]                             # a rigid edge: each motion "fixed", "free", moved or loaded
edge     = "top"
x        = "fixed"
rotation = "fixed"
y        = { force_N_per_mm = -18.5, history = "press" }

[support.shaker]
edge     = "bottom"
y        = "fixed"
rotation = "fixed"
x        = { motion_mm = 0.025, history = "stroke" }

[history]                                    # [progress of the step, factor]; corners are always ends of increments
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]

[[step]]                                     # plays the histories named; the others hold their last factor
name = "press"
play = ["press"]
increments = 10
wear = false

[[step]]
name = "run in without wear"
play = ["stroke"]
increments = 40
wear = false

[[step]]
name = "wear"
play = ["stroke"]
increments = 40
cycles = 18000
jump = 100                                   # fixed; or { tolerance = 0.01 }

[limit.life]                                 # the first cycle at which it is reached; the run continues unless stop = true
contact  = "pad"
side     = "secondary"
depth_mm = 0.0025

[output]
frames = { every_cycles = 1000 }             # ParaView frames; the surface tables have a row set at each
probes = { edge = { body = "flat", at_mm = [0.5, 0.0] } }
)";

}  // namespace reye::test
