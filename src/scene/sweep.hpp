#pragma once
#include <string>
#include <vector>

#include "scene/spec.hpp"

/// Variations of a scene: each member has other values at the keys that are varied.
namespace reye::scene {

/// One key and the values it takes, as written in TOML.
struct Variation {
  std::string key;
  std::vector<std::string> values;
};

/// `key=a:b:n`: n numbers from a to b, both included; `key=log:a:b:n`: with equal ratios;
/// `key=v1,v2,...`: these values; one that is not a number, truth value, list, table or quoted text is a text.
/// Throws base::InputError with the rule that is broken.
Variation variation_of(const std::string& words);

struct Member {
  std::vector<std::string> values;  ///< one per variation, as written
  std::string text;                 ///< its scene, with absolute paths
};

struct Sweep {
  std::vector<std::string> keys;
  std::vector<Member> members;  ///< the full grid, the last key fastest
};

/// The members of a scene under all variations, none of them read yet; the scene itself is fine. `text`: what the file
/// at `path` holds, or would hold; `keys`: of its kind.
/// Throws base::InputError with all errors of the variations: a key that is unknown, that stands where
/// the scene has no table of that name, is varied twice or cannot be set.
Sweep sweep_of(const std::string& text, const std::string& path, const std::vector<std::string>& variations,
               const Spec& keys);

/// Of the scene file at `path`.
Sweep sweep_of(const std::string& path, const std::vector<std::string>& variations, const Spec& keys);

/// Of a plane scene, whose own errors are thrown once, and not once per member.
Sweep sweep_of(const std::string& path, const std::vector<std::string>& variations);

}  // namespace reye::scene
