#pragma once
#include <string>

namespace reye::apps {

struct NewRequest {
  std::string name;  ///< of the part: headline and, without `out`, folder
  std::string like;  ///< kind of contact: a folder of geo/like
  std::string out;   ///< folder to make; empty: ./NAME
  bool list = false;
};

/// `reye new`: makes a folder with a commented scene and its geometry, to start from. Throws base::InputError where the
/// name, the kind or the folder cannot be used; nothing is made then.
int new_scene(const NewRequest& request);

}  // namespace reye::apps
