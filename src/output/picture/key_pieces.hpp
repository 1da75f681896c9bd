#pragma once
#include <map>
#include <string>

#include "scene/scene.hpp"

/// Pieces of the key below a picture of a scene, in pixels.
namespace reye::output {

inline constexpr double picture_width = 1120.0;

std::string key_text(double x, double y, const std::string& words, const char* colour = "#2b2f36");

/// Words of the key from x on, broken into lines where the picture ends; y is moved below them.
std::string key_lines(double x, double& y, const std::string& words, double line_height);

/// The histories as small curves in rows of four from y on, which is moved below them.
std::string history_curves(const std::map<std::string, scene::History>& histories, double left, double& y);

/// The picture with its title, of so many pixels in height.
std::string whole_picture(const std::string& title, double left, const std::string& content, double height);

}  // namespace reye::output
