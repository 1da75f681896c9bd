#include "cad/meshing/region_bytes.hpp"

#include <algorithm>
#include <stdexcept>

#include "cad/part/bytes.hpp"

namespace reye::cad {

template <class Archive>
void pass(Archive& archive, RegionLoop& loop) {
  archive(loop.nodes), archive(loop.corner);
}

template <class Archive>
void pass(Archive& archive, Region& region) {
  archive(region.X), archive(region.kind), archive(region.cells), archive(region.loops);
}

template <class Archive>
void pass(Archive& archive, RegionToFill& request) {
  archive(request.region), archive(request.size);
}

template <class Archive>
void pass(Archive& archive, FilledRegion& answer) {
  archive(answer.region), archive(answer.failure);
}

namespace {

bool is_of(const mesh::Cell& cell, mesh::CellKind kind, std::size_t nodes) {
  const int n = mesh::nodes_per_cell(kind);
  const auto known = [&](int node) { return node >= 0 && static_cast<std::size_t>(node) < nodes; };
  return std::all_of(cell.begin(), cell.begin() + n, known) &&
         std::all_of(cell.begin() + n, cell.end(), [](int node) { return node == -1; });
}

}  // namespace

std::string bytes_of(const RegionToFill& request) { return written(request); }
std::string bytes_of(const FilledRegion& answer) { return written(answer); }

RegionToFill region_to_fill_of(std::string_view bytes) { return read_whole<RegionToFill>(bytes); }

FilledRegion filled_region_of(std::string_view bytes, const Region& asked) {
  FilledRegion answer = read_whole<FilledRegion>(bytes);
  if (!answer.failure.empty()) return answer;
  const Region& region = answer.region;
  if (region.X.size() < asked.X.size() || !std::equal(asked.X.begin(), asked.X.end(), region.X.begin()))
    throw std::runtime_error("moves nodes of the outline");
  if (region.kind != asked.kind || region.cells.empty() || !region.loops.empty() ||
      !std::all_of(region.cells.begin(), region.cells.end(),
                   [&](const mesh::Cell& cell) { return is_of(cell, region.kind, region.X.size()); }))
    throw std::runtime_error("holds cells that are not of its nodes");
  return answer;
}

}  // namespace reye::cad
