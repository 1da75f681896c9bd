#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "output/solid/depth_picture.hpp"
#include "output/solid/solid_actions.hpp"

namespace reye::output {

/// Colours of the skins: of each body, and of the faces that stand out of it.
struct SkinPaint {
  std::vector<std::string> body;                          ///< "#rrggbb"
  std::vector<std::map<std::string, std::string>> faces;  ///< by body and name, "#rrggbb"; the first by rank wins
  std::vector<std::vector<std::string>> rank;             ///< by body: the names of faces, the most important first
};

/// A field of the picture that shows some bodies from one side, and what is written on it.
class SolidPanel {
 public:
  SolidPanel(const SpaceView& view, const BodyMeshes& bodies, const SkinPaint& paint, const std::set<int>& shown,
             bool elements);

  const SpaceView& view() const { return view_; }

  /// A place on a face (empty: on the body beside its named faces) that is seen, in its middle; none where all of it is
  /// covered or beyond the field.
  std::optional<Vec3> seen_place(int body, const std::string& face) const;

  /// Adds a name beside a place where there is room; nothing where there is none.
  void name(const Vec3& at, const std::string& words, const std::string& colour);
  /// Adds a letter in a circle with a line to its place; arrows in directions of space.
  void mark(const Vec3& at, const SolidAction& action);
  /// Adds a dashed ball or box.
  void zone(const cad::SolidFineZone& zone);

  /// The field as SVG with title, axes and bar of size; `id` is that of its clip path.
  std::string svg(const std::string& title, const std::string& id) const;

 private:
  void draw_edges(const BodyMeshes& bodies, int body, bool elements);
  std::string seen_parts(const Vec3& a, const Vec3& b) const;
  Vec2 free_place(const Vec2& wanted, const Vec2& size);

  SpaceView view_;
  const BodyMeshes& bodies_;
  const SkinPaint& paint_;
  DepthPicture depth_;
  std::set<int> shown_;
  std::vector<Box> taken_;  ///< by names and letters, in pixels
  std::string feature_lines_, element_lines_, dashed_, above_;
};

}  // namespace reye::output
