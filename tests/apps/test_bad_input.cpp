#include "bad_scene.hpp"

using namespace reye;

// A scene that has no solution must be refused with its reason: a free motion by its name, a contact that cannot work
// by its side.
TEST(BadInput, WhatCannotBeSolved) {
  const std::vector<test::BadScene> scenes = {
      {"nothing holds a body",
       {{test::holder, R"()"}, {test::rough, R"()"}},
       "",
       R"(scene.toml:7: body.slider: translation along x is free: no support holds it and no load drives it)"
       "\n"
       R"(scene.toml:7: body.slider: translation along y is free: no support holds it and no load drives it)"
       "\n"
       R"(scene.toml:7: body.slider: rotation is free: no support holds it and no load drives it)"},
      {"loaded but not guided",
       {{R"(x        = "fixed"
y        = { force_N_per_mm = -20.0, history = "press" }
rotation = "fixed")",
         R"(y        = { force_N_per_mm = -20.0, history = "press" })"},
        {test::rough, R"()"}},
       "",
       R"(scene.toml:7: body.slider: translation along x is free: no support holds it and no load drives it)"
       "\n"
       R"(scene.toml:7: body.slider: rotation is free: no support holds it and no load drives it)"},
      {"one motion free",
       {{R"(x        = "fixed"
y        = "fixed"
rotation = "fixed"

[history])",
         R"(y        = "fixed"

[history])"},
        {test::rough, R"()"}},
       "",
       R"(scene.toml:11: body.base: translation along x is free: no support holds it and no load drives it)"},
      {"opposite edge of the same body",
       {{R"(["base_top"])", R"(["slider_top"])"}},
       "",
       R"(scene.toml:17: contact.pad.primary = "slider_top": lies on the same body as the secondary side ("slider"))"},
      {"neighbouring edge of the same body",
       {{R"(["base_top"])", R"(["slider_right"])"}},
       "",
       R"(scene.toml:17: contact.pad.primary = "slider_right": lies on the same body as the secondary side ("slider"))"},
      {"edges that look away",
       {{R"(["base_top"])", R"(["base_bottom"])"}, {R"(edge     = "base_bottom")", R"(edge     = "base_top")"}},
       "",
       R"(scene.toml:15: contact.pad: no facet of the secondary side faces a primary one within search_mm = 1.5: they do not face each other; name boundaries that do)"},
      {"too far apart",
       {{R"("slider_bottom")", R"("slider_right")"}, {R"(wear )", R"(search_mm = 0.1
wear )"}},
       "",
       R"(scene.toml:15: contact.pad: no facet of the secondary side faces a primary one within search_mm = 0.1: they do not face each other; name boundaries that do)"},
      {"secondary side on a rigid body",
       {{R"([body.slider]
material = "steel"
mesh     = { far_size_mm = 0.5 })",
         R"([body.slider]
rigid = true)"}},
       "",
       R"(scene.toml:15: contact.pad.secondary = "slider_bottom": lies on the rigid body "slider"; the secondary side must belong to a deformable body)"},
      {"secondary side as rigid edge",
       {{R"(edge     = "slider_top")", R"(edge     = "slider_bottom")"}},
       "",
       R"(scene.toml:16: contact.pad.secondary = "slider_bottom": is the rigid edge of support "holder"; the secondary side must deform)"},
      {"secondary side in a rigid edge",
       {{R"(edge     = "slider_top")", R"(edge     = "outline")"}},
       R"(
[boundary]
outline = { body = "slider" }
)",
       R"(scene.toml:16: contact.pad.secondary = "slider_bottom": lies on the rigid edge of support "holder"; its nodes must be free to move)"},
      {"rigid primary side that wears",
       {{R"([body.base]
material = "steel"
mesh     = { far_size_mm = 0.5 })",
         R"([body.base]
rigid = true)"}},
       "",
       R"(scene.toml:18: contact.pad.wear: the primary side lies on the rigid body "base", which cannot wear)"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}

// All errors of a stage must be reported at once, in the order of the file.
TEST(BadInput, SeveralAtOnce) {
  const std::vector<test::BadScene> scenes = {
      {"three unknown edges",
       {{R"(secondary = "slider_bottom")", R"(secondary = "slider_botom")"},
        {R"(edge     = "base_bottom")", R"(edge     = "floor")"},
        {R"(edge     = "slider_top")", R"(edge = "left")"}},
       "",
       R"(scene.toml:16: contact.pad.secondary = "slider_botom": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"
       "\n"
       R"(scene.toml:22: support.holder.edge = "left": more than one body has a boundary of this name; write body.name)"
       "\n"
       R"(scene.toml:28: support.floor.edge = "floor": no boundary has this name; there are slider.left, slider.slider_bottom, slider.slider_right, slider.slider_top, base.base_bottom, base.base_top, base.left)"},
      {"bodies and boundaries",
       {{R"([body.slider])", R"([body.slidr])"}, {R"([body.base])", R"([body.base]
at = [9.0, 9.0])"}},
       R"(
[boundary]
round = { body = "base", type = "circle" }
)",
       R"(scene.toml:7: body.slidr: has neither 'at' nor 'name', and its own name is that of no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"
       "\n"
       R"(scene.toml:12: body.base.at = [9, 9]: the point lies in no face; there are: 'slider' in [1, 0, 3, 1], 'base' in [0, -1, 4, 0])"},
      {"values and names",
       {{R"(nu    = 0.3)", R"(nu    = 0.5)"},
        {R"(friction  = 0.3)", R"(friction = -1.0)"},
        {R"(play = ["press"])", R"(play = ["pres"])"}},
       "",
       R"(scene.toml:5: material.steel.nu = 0.5: must lie in (-1, 0.5))"
       "\n"
       R"(scene.toml:18: contact.pad.friction = -1.0: must be >= 0)"
       "\n"
       R"(scene.toml:37: step[0].play = ["pres"]: there is no history "pres"; did you mean "press"?)"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}
