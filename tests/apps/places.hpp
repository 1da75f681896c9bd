#pragma once
#include <string>

#include "command.hpp"
#include "scenes.hpp"

/// Places with a small scene in them.
namespace reye::test {

/// The wearing contact.
struct WithWearing : Place {
  explicit WithWearing(const std::string& scene = wearing) {
    write("wearing.geo", wearing_geo);
    write("wearing.toml", scene);
  }
};

/// The two blocks.
struct WithBlocks : Place {
  explicit WithBlocks(const std::string& scene = blocks, const std::string& file = "blocks.toml") {
    write("blocks.geo", blocks_geo);
    write(file, scene);
  }
};

}  // namespace reye::test
