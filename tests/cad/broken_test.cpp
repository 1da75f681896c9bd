#include "cad/part/raw_bytes.hpp"
#include "support.hpp"
#include "support/sanitizers.hpp"

namespace {

using namespace reye;
using namespace reye::cad;

std::string refusal_of_broken(const std::string& file) { return refusal_of_file(data("broken/" + file), 2, -0.5); }

// Files that make gmsh or OpenCASCADE crash, or want all memory, must be refused by name like any other.
TEST(broken, files_that_crash_their_readers) {
  for (const char* file : {"cut300.brep", "map_of_none.msh", "tag_of_none.msh", "enormous_count.msh", "line_32.step",
                           "line_62.step", "line_68.step", "reference_of_none.step"}) {
    const std::string told = refusal_of_broken(file);
    EXPECT_TRUE(told.starts_with("geometry = \"" + data(std::string("broken/") + file) + "\": "))
        << file << ": " << told;
  }
}

// A .vtu whose counts, offsets, components or node numbers are not those of a mesh must be refused with what is wrong.
TEST(broken, vtu) {
  const std::pair<const char*, const char*> files[] = {
      {"names_2e9.vtu", "GB of memory"},
      {"ncells_huge.vtu", "GB of memory"},
      {"npts_huge.vtu", "GB of memory"},
      {"off_first0.vtu", "cell 0 has no points"},
      {"refpos_comp500.vtu", "three components each"},
      {"refpos_comp9.vtu", "three components each"},
      {"types_line_as_quad.vtu", "cell 8 has 2 points, its kind 4"},
      {"types_quad8_with4.vtu", "cell 0 has 4 points, its kind 8"},
      {"bytes_319.vtu", ""},
      {"bytes_12.vtu", ""},
  };
  for (const auto& [file, rule] : files) {
    const std::string told = refusal_of_broken(file);
    EXPECT_TRUE(told.starts_with("geometry = ")) << file;
    if (support::address_sanitizer && std::string_view(rule) == "GB of memory") continue;
    EXPECT_NE(told.find(rule), std::string::npos) << file << ": " << told;
  }
}

// A node number beyond 2^32 is not the node that is left of it in 32 bits: it must be what a sound file is refused for.
TEST(broken, node_beyond_32_bits) {
  std::ifstream file(data("broken/off_first0.vtu"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto put_first = [&](const std::string& array, const std::string& number) {
    const auto first = text.find_first_of("0123456789", text.find('>', text.find('"' + array + '"')));
    text.replace(first, text.find_first_of(" \n", first) - first, number);
  };
  put_first("offsets", "4");
  EXPECT_EQ(refusal_of_file(temporary_file("sound.vtu", text), 2, -0.5), "");
  put_first("connectivity", "4294967296");
  const std::string told = refusal_of_file(temporary_file("far_node.vtu", text), 2, -0.5);
  EXPECT_NE(told.find("4294967296"), std::string::npos) << told;
}

// One bad file among sound ones must be reported alone, with what is wrong with it.
TEST(broken, among_others) {
  GeometryOptions options;
  options.files = {data("broken/line_32.step"), data("plate.step"), data("broken/off_first0.vtu")};
  options.bodies = {body_at("body", 1, 1)};
  try {
    build(options);
    FAIL();
  } catch (const base::InputError& error) {
    ASSERT_EQ(error.issues().size(), 2u) << error.what();
    EXPECT_EQ(error.issues()[0].value, "\"" + options.files[0] + "\"");
    EXPECT_EQ(error.issues()[1].value, "\"" + options.files[2] + "\"");
  }
}

RawPart some_part() {
  RawPart part{{}, "plate", true, {}, {}, {}};
  part.curves.push_back(
      {3, EdgeType::circle, {Vec3(0, 0, 0), Vec3(1, 2, 3)}, {Vec3(1, 0, 0), Vec3(0, 1, 0)}, {"left", "top"}});
  part.surface_points = {Vec3(0.5, 0.5, 0)};
  part.mesh.kind = mesh::CellKind::tri3;
  part.mesh.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  part.mesh.cells = {mesh::cell_of({0, 1, 2})};
  part.mesh.names[{0, 1}] = {"bottom"};
  return part;
}

// What goes through the importer's pipe must come out as it went in.
TEST(broken, answer_comes_back) {
  const std::string bytes = to_bytes({{some_part()}, {{"geometry", "\"a\"", "is empty"}}});
  const Answer answer = answer_of(bytes);
  EXPECT_EQ(to_bytes(answer), bytes);
  EXPECT_EQ(answer.parts[0].label, "plate");
  EXPECT_EQ(answer.parts[0].curves[0].points[1], Vec3(1, 2, 3));
  EXPECT_EQ(answer.parts[0].mesh.names.at({0, 1}).count("bottom"), 1u);
  EXPECT_EQ(answer.issues[0].rule, "is empty");
}

// Bytes that are cut or changed anywhere must be refused, or give an answer with all that a mesh relies on.
TEST(broken, answer_of_any_bytes) {
  const std::string bytes = to_bytes({{some_part()}, {}});
  for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_THROW(answer_of(bytes.substr(0, n)), std::runtime_error) << n;
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int byte : {0x00, 0x01, 0x7f, 0xff}) {
      std::string other = bytes;
      other[at] = static_cast<char>(byte);
      try {
        for (const RawPart& part : answer_of(other).parts)
          for (const mesh::Cell& cell : part.mesh.cells)
            for (int k = 0; k < 3; ++k) ASSERT_LT(static_cast<std::size_t>(cell[k]), part.mesh.nodes.size());
      } catch (const std::runtime_error&) {
      }
    }
}

}  // namespace
