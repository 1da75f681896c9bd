#pragma once

/// The scenes that the members change. The slider rubs to and fro on the base.
namespace reye::test {

/// Two elastic blocks; the slider is narrower and carries the multipliers.
inline const char* const rubbing = R"(geometry = ["slider.msh", "base.msh"]
[material.upper]
E_MPa = @MPa(200e3)
nu    = 0.3
[material.lower]
E_MPa = @MPa(200e3)
nu    = 0.3
[body.slider]
material = "upper"
[body.base]
material = "lower"
[contact.pad]
secondary = "slider_bottom"
primary   = ["base_top"]
friction  = 0.3
wear      = { law = "energy", secondary_mm3_per_J = @mm3_per_J(3.0e-5), primary_mm3_per_J = @mm3_per_J(2.0e-5) }
[support.holder]
edge     = "slider_top"
x        = { motion_mm = @mm(0.01), history = "stroke" }
y        = { force_N_per_mm = @N_per_mm(-20.0), history = "press" }
rotation = "fixed"
[support.floor]
edge     = "base_bottom"
x        = "fixed"
y        = "fixed"
rotation = "fixed"
[history]
press  = [[0.0, 0.0], [1.0, 1.0]]
stroke = [[0.0, 0.0], [0.25, 1.0], [0.75, -1.0], [1.0, 0.0]]
[[step]]
name = "press"
play = ["press"]
wear = false
[[step]]
name = "wear"
play = ["stroke"]
increments = 8
cycles = 20
jump = 10
[output.frames]
every_increment = true
every_blocks = 1
)";

/// Two rubber blocks at finite strain: the slider is pressed in by 15 % and drawn until a third of it hangs over.
inline const char* const drawn = R"(geometry = ["slider.msh", "base.msh"]
[material.upper]
law   = "neo_hookean"
E_MPa = @MPa(100.0)
nu    = 0.3
[material.lower]
law   = "neo_hookean"
E_MPa = @MPa(100.0)
nu    = 0.3
[body.slider]
material   = "upper"
kinematics = "finite"
[body.base]
material   = "lower"
kinematics = "finite"
[contact.pad]
secondary = "slider_bottom"
primary   = ["base_top"]
friction  = 0.2
wear      = { law = "energy", secondary_mm3_per_J = @mm3_per_J(1.0e-4), primary_mm3_per_J = @mm3_per_J(1.0e-4) }
[support.holder]
edge = "slider_top"
x    = { motion_mm = @mm(1.6), history = "draw" }
y    = { motion_mm = @mm(-0.15), history = "press" }
[support.floor]
edge = "base_bottom"
x    = "fixed"
y    = "fixed"
[history]
press = [[0.0, 0.0], [1.0, 1.0]]
draw  = [[0.0, 0.0], [1.0, 1.0]]
[[step]]
name = "press"
play = ["press"]
increments = 2
wear = false
[[step]]
name = "draw"
play = ["draw"]
increments = 12
cycles = 1
[output.frames]
every_increment = true
every_blocks = 1
)";

}  // namespace reye::test
