#include "support.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

const std::string rectangle = "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 1, 1};\n";

std::string refusal_of_script(const std::string& text) {
  return refusal_of_file(temporary_file("script.geo", rectangle + text));
}

// A script that acts on anything but the model must be refused with its line, the word and the remedy, however it is
// hidden.
TEST(script, harmful_commands) {
  const char* const commands[] = {
      "SystemCall \"touch harm\";",
      "NonBlockingSystemCall \"touch harm\";",
      "OnelabRun(\"a\", \"touch harm\");",
      "Merge \"other.step\";",
      "Save \"harm.msh\";",
      "Print \"harm.png\";",
      "CreateDir \"harm\";",
      "Plugin(MathEval).Run;",
      "ShapeFromFile(\"other.brep\");",
      "x = \"touch harm\"; SystemCall = 1; SystemCall x;",
      "If (1) SystemCall \"touch harm\"; EndIf",
      "If (0) x = 1; Else SystemCall \"touch harm\"; EndIf",
      "General.ExecutableName = \"harm\";",
      "Solver.Executable0 = \"harm\";",
      "Field[1] = ExternalProcess; Field[1].CommandLine = \"touch harm\";",
      "x[] = ListFromFile(\"/etc/passwd\");",
      "Exit;",
  };
  for (const char* command : commands) {
    const std::string told = refusal_of_script(std::string(command) + "\n");
    EXPECT_NE(told.find("line 3: "), std::string::npos) << command << ": " << told;
    EXPECT_NE(told.find("--trust-geometry"), std::string::npos) << command << ": " << told;
  }
  const std::string path = temporary_file("named.geo", rectangle + "SystemCall \"touch harm\";\n");
  EXPECT_EQ(refusal_of_file(path),
            "geometry = \"" + path +
                "\": line 3: SystemCall is neither a command that Reye lets a script use nor a variable that "
                "it sets; take it out, or run with --trust-geometry if you trust the file");
}

// Printf to a file must be refused, Printf to the screen not.
TEST(script, printing) {
  EXPECT_EQ(refusal_of_script("Printf(\"%g mm\", 2);\n"), "");
  for (const char* sign : {">", ">>"})
    EXPECT_NE(refusal_of_script("Printf(\"%g\", 2) " + std::string(sign) + " \"harm\";\n").find("may not write a file"),
              std::string::npos);
}

// Where gmsh jumps over parts of a script by searching for words, texts and comments must not hide any.
TEST(script, hidden_commands) {
  for (const char* text : {"If (0)\n/* EndIf SystemCall 'touch harm'; If (1) */\nEndIf\n",
                           "If (0)\nx = \" EndIf SystemCall \"; y = \"; touch harm ; \";\nEndIf\n",
                           "For i In {1:2} /*\nSystemCall 'touch harm';\n*/\nEndFor\n", "x = \"//\"; /* y */\n",
                           "x = \"a\nb\";\n", "/* never ends\n", "\x01\n"})
    EXPECT_NE(refusal_of_script(text).find("--trust-geometry"), std::string::npos) << text;
}

// What drawings are made of must be allowed: variables, lists, loops, branches, macros, fields, options.
TEST(script, harmless_commands) {
  const std::string text = R"(// A comment
r = 0.5; n[] = {}; k~{1} = 2; DefineConstant[ w = {2, Min 1, Max 3, Name "Width"} ];
For i In {0:3}
  p = newp; Point(p) = {3 + r*Cos(i*Pi/2), 3 + r*Sin(i*Pi/2), 0, 0.1};
  n[i] = p; n[] += p;
EndFor
If (r > w) Printf("large"); ElseIf (r == w) Printf("same"); Else w += 1; EndIf
Macro Shift
  Translate {0, r, 0} { Point{p}; }
Return
Call Shift;
Disk(7) = {5, 5, 0, r}; Physical Surface(Sprintf("disc%g", 1)) = {7};
Field[1] = Distance; Field[1].PointsList = {p}; Background Field = 1;
Mesh.MeshSizeMax = 1e22; Geometry.Tolerance = 1e-8; General.Terminal = 0;
Transfinite Curve {1, 2} = 5 Using Progression r;
MeshSize { PointsOf{ Surface{7}; } } = (r < 1) ? 0.1 : w;
)";
  EXPECT_EQ(refusal_of_script(text), "");
}

// Scripts may include files in their folder or below, which are checked as well; symbolic links do not lead
// out.
TEST(script, includes) {
  EXPECT_EQ(refusal_of_script("Include \"part.inc\";\n").substr(0, 11), "geometry = ");
  temporary_file("part.inc", "q = 3;\nSystemCall \"touch harm\";\n");
  EXPECT_NE(refusal_of_script("Include \"part.inc\";\n").find("of part.inc, line 2: SystemCall"), std::string::npos);
  const std::filesystem::path part = temporary_file("part.inc", "q = 3;\n");
  EXPECT_EQ(refusal_of_script("Include \"part.inc\";\nz = q;\n"), "");
  EXPECT_NE(refusal_of_script("Include \"/etc/passwd\";\n").find("must lie in the folder"), std::string::npos);
  EXPECT_NE(refusal_of_script("x = \"part.inc\"; Include x;\n").find("must name its file in quotes"),
            std::string::npos);
  std::filesystem::remove(part);
  std::filesystem::create_symlink("/etc/passwd", part);
  EXPECT_NE(refusal_of_script("Include \"part.inc\";\n").find("must lie in the folder"), std::string::npos);
  std::filesystem::remove(part);
}

// A file must begin as files of its format do, whatever gmsh would make of it.
TEST(script, by_another_name) {
  for (const char* name : {"a.step", "a.stp", "a.brep", "a.iges", "a.igs", "a.msh", "a.vtu"}) {
    const std::string told = refusal_of_file(temporary_file(name, rectangle + "SystemCall \"touch harm\";\n"));
    EXPECT_NE(told.find("is not a"), std::string::npos) << told;
  }
  const std::string mesh =
      temporary_file("post.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PostFormat\n$EndPostFormat\n");
  EXPECT_NE(refusal_of_file(mesh).find("line 4: $PostFormat is not a section of a mesh"), std::string::npos);
}

}  // namespace
