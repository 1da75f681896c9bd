#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The worn shape of a run as files for CAD or tables, from its folder alone.
namespace reye::output {

struct ShapeWish {
  std::string dir, format, body;       ///< body: this one alone; empty: all
  std::optional<double> cycle;         ///< the last frame at this cycle
  std::optional<long> frame;           ///< with neither the last frame
  std::optional<double> thickness_mm;  ///< of a plane body as stl
};

struct ExportedShape {
  std::size_t frame = 0;
  double cycle = 0.0;
  /// One text, or several of one body each, which is named.
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::string> lines, warnings;  ///< what is in them: a table for the user
};

/// Makes the texts; writes nothing. Throws base::InputError for wishes that the run or the format does not allow, all
/// of them together, and where the shape of the frame lacks most of the wear.
ExportedShape export_shape(const ShapeWish& wish);

/// The frames of a run as a table for the user.
std::vector<std::string> frames_in_words(const std::string& dir);

/// Whether the file is a former export.
bool is_export(const std::string& file);

}  // namespace reye::output
