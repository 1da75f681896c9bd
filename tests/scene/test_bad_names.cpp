#include "bad_scene.hpp"

using namespace reye;

/// Rules between tables: what is named exists and can play its part.
TEST(BadScene, Names) {
  const std::vector<test::BadScene> scenes = {
      {"unknown material",
       {{R"(material = "steel")", R"(material = "stel")"}},
       R"(scene.toml:12: body.cylinder.material = "stel": there is no material "stel"; did you mean "steel"?)"},
      {"unknown bodies",
       {{R"(body = "cylinder", box)", R"(body = "cylindre", box)"},
        {R"(body = "flat", at_mm)", R"(body = "falt", at_mm)"}},
       R"(scene.toml:21: boundary.top.body = "cylindre": there is no body "cylindre"; did you mean "cylinder"?)"
       "\n"
       R"(scene.toml:75: output.probes.edge.body = "falt": there is no body "falt"; did you mean "flat"?)"},
      {"both sides on one body",
       {{R"(["round"])", R"(["bottom"])"}},
       R"(scene.toml:28: contact.pad.primary = ["bottom"]: "bottom" lies on the body of the secondary side, "flat")"},
      {"rigid secondary body",
       {{"at       = [0.0, -3.0]\n"
         R"(material = "steel")",
         "at = [0.0, -3.0]\n"
         "rigid = true"}},
       R"(scene.toml:27: contact.pad.secondary = "face": lies on the rigid body "flat"; the secondary side must deform)"},
      {"rigid secondary edge",
       {{R"(edge     = "bottom")", R"(edge = "face")"}},
       R"(scene.toml:27: contact.pad.secondary = "face": is the rigid edge of support "shaker"; the secondary side must deform)"},
      {"the same two edges in two contacts",
       {{"[support.holder]",
         "[contact.other]\n"
         R"(secondary = "face")"
         "\n"
         R"(primary = ["top", "round"])"
         "\n"
         "[support.holder]"}},
       R"(scene.toml:35: contact.other.primary = ["top", "round"]: "round" meets "face" in contact "pad" already)"},
      {"secondary in a contact and a bond",
       {{"[support.holder]",
         "[bond.other]\n"
         R"(secondary = "face")"
         "\n"
         R"(primary = ["top"])"
         "\n"
         "[support.holder]"}},
       R"(scene.toml:34: bond.other.secondary = "face": is already the secondary side of contact "pad", and a bonded boundary can have no other contact)"},
      {"ring of contacts",
       {{"[support.holder]",
         "[contact.back]\n"
         R"(secondary = "round")"
         "\n"
         R"(primary = ["face"])"
         "\n"
         "[support.holder]"}},
       "scene.toml:26: contact.pad: secondary and primary sides form a ring: pad, back"},
      {"unknown history",
       {{R"(history = "stroke")", R"(history = "strok")"},
        {R"(play = ["press"])", R"(play = ["pres", "stroke", "stroke"])"}},
       R"(scene.toml:43: support.shaker.x.history = "strok": there is no history "strok"; did you mean "stroke"?)"
       "\n"
       R"(scene.toml:51: step[0].play = ["pres", "stroke", "stroke"]: there is no history "pres"; did you mean "press"?)"
       "\n"
       R"(scene.toml:51: step[0].play = ["pres", "stroke", "stroke"]: names "stroke" twice)"},
      {"steps",
       {{"cycles = 18000", "cycles = -1"}, {"jump = 100 ", "jump = 0.5 "}, {R"(name = "wear")", R"(name = "press")"}},
       R"(scene.toml:62: step[2].name = "press": another step has this name)"
       "\n"
       "scene.toml:65: step[2].cycles = -1: must be >= 0\n"
       "scene.toml:66: step[2].jump = 0.5: must be >= 1"},
      {"limits",
       {{R"(contact  = "pad")", R"(contact = "pda")"},
        {"depth_mm = 0.0025",
         "area_mm2 = 0.1\n"
         "depth_mm = 0.1"}},
       "scene.toml:68: limit.life: takes only one of depth_mm, area_mm2\n"
       R"(scene.toml:69: limit.life.contact = "pda": there is no contact "pda"; did you mean "pad"?)"},
  };
  for (const auto& bad : scenes) test::expect_refused(bad);
}

/// A file without anything says what every scene needs.
TEST(BadScene, Empty) {
  EXPECT_EQ(test::refusal("# nothing\n"),
            "scene.toml:1: geometry: missing\n"
            "scene.toml:1: body: missing; a scene has at least one body\n"
            "scene.toml:1: step: missing; a scene has at least one [[step]]");
}

/// Steps are a list, even a single one.
TEST(BadScene, StepAsOneTable) {
  EXPECT_EQ(test::refusal("geometry = [\"cylinder_on_flat.step\"]\nbody.disc.rigid = true\n[step]\nincrements = 3\n"),
            "scene.toml:3: step: must be a list of tables, each headed [[step]]");
}

/// A scene file that is not there, or is a folder.
TEST(BadScene, NoFile) {
  const test::Folder folder;
  const auto message = [](const std::string& path) {
    try {
      scene::read(path);
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("none/scene.toml"), "none/scene.toml: no such file");
  EXPECT_EQ(message("."), ".: cannot be read");
}
