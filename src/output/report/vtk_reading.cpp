#include "output/report/vtk_reading.hpp"

#include <vtkBase64Utilities.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "output/folder/files.hpp"

namespace reye::output {

namespace {

/// What precedes the packed bytes of an array: its full blocks, the bytes of each, and those of the last one.
using BlockSizes = std::array<std::uint64_t, 3>;

BlockSizes block_sizes(std::string_view packed) {
  constexpr std::size_t characters = 4 * sizeof(BlockSizes) / 3;
  BlockSizes sizes{};
  if (packed.size() < characters) return sizes;  // the reader says so
  const auto* from = reinterpret_cast<const unsigned char*>(packed.data());
  vtkBase64Utilities::DecodeSafely(from, characters, reinterpret_cast<unsigned char*>(sizes.data()), sizeof sizes);
  return sizes;
}

}  // namespace

std::string text_of_possible_sizes(const std::string& path) {
  constexpr std::string_view binary = "format=\"binary\"", white = " \n\r\t";
  constexpr std::uint64_t densest = 1032;  // zlib packs no run of bytes closer (zlib.net, "Technical details")
  std::string file = read_text(path);
  const std::string_view text = file;
  if (text.find("compressor=\"vtkZLibDataCompressor\"") == text.npos) return file;
  for (auto at = text.find(binary); at != text.npos; at = text.find(binary, at + 1)) {
    const auto begin = text.find_first_not_of(white, std::min(text.find('>', at), text.size() - 1) + 1);
    if (begin == text.npos) break;
    const auto [blocks, bytes, last] = block_sizes(text.substr(begin));
    const std::uint64_t most = densest * text.size();
    if (blocks > most || bytes > most || last > most || (blocks > 1 && bytes > most / (blocks - 1)))
      damaged_frame(path);
  }
  return file;
}

}  // namespace reye::output
