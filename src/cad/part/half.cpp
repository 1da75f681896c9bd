#include "cad/part/half.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "cad/part/axis_pieces.hpp"
#include "cad/part/text.hpp"

namespace reye::cad {

namespace {

/// Edges at x >= 0 that follow one another, with the edges of the whole that they come from.
struct HalfRun {
  Loop edges;
  std::vector<std::array<int, 2>> whole;
};

/// A piece of a loop on one side of the axis, with the edge of the whole that it comes from.
struct LoopPiece {
  AxisPiece piece;
  std::array<int, 2> whole;
};

std::vector<LoopPiece> pieces_of(const Part& part, int loop, double width) {
  const Loop& edges = part.loops[static_cast<std::size_t>(loop)];
  std::vector<LoopPiece> pieces;
  for (int k = 0; k < static_cast<int>(edges.size()); ++k)
    for (AxisPiece& piece : axis_pieces(edges[static_cast<std::size_t>(k)], width))
      pieces.push_back({std::move(piece), {loop, k}});
  return pieces;
}

/// The part of a loop at x > 0: runs from axis to axis, or the whole loop as a closed one.
std::vector<HalfRun> runs_of(const Part& part, int loop, double width, bool& closed) {
  std::vector<LoopPiece> pieces = pieces_of(part, loop, width);
  const auto right = [](const LoopPiece& piece) { return piece.piece.side > 0; };
  closed = std::all_of(pieces.begin(), pieces.end(), right);
  if (!closed) std::rotate(pieces.begin(), std::find_if_not(pieces.begin(), pieces.end(), right), pieces.end());
  std::vector<HalfRun> runs;
  bool open = false;
  for (LoopPiece& piece : pieces) {
    if (right(piece) && !open) runs.emplace_back();
    open = right(piece);
    if (!open) continue;
    runs.back().edges.push_back(std::move(piece.piece.edge));
    runs.back().whole.push_back(piece.whole);
  }
  return runs;
}

/// An end of a run on the axis. Between a beginning and the end above it lies material.
struct AxisEnd {
  double y = 0.0;
  bool begins = false;
  std::size_t run = 0;
};

/// For each run, the one that continues from where it ends, down the axis.
std::vector<std::size_t> next_runs(const std::vector<HalfRun>& runs) {
  std::vector<AxisEnd> ends;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    ends.push_back({runs[r].edges.front().first().y(), true, r});
    ends.push_back({runs[r].edges.back().last().y(), false, r});
  }
  std::sort(ends.begin(), ends.end(),
            [](const AxisEnd& a, const AxisEnd& b) { return a.y != b.y ? a.y < b.y : a.begins < b.begins; });
  std::vector<std::size_t> next(runs.size());
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    if (!ends[i].begins || ends[i + 1].begins)
      throw base::MeshError("its outline meets the axis x = 0 at y = " + text(ends[i].y) +
                            " without passing through it");
    next[ends[i + 1].run] = ends[i].run;
  }
  return next;
}

/// Runs and lines along the axis, one loop after the other.
void join(const std::vector<HalfRun>& runs, Half& half) {
  const auto next = next_runs(runs);
  std::vector<char> used(runs.size(), 0);
  for (std::size_t first = 0; first < runs.size(); ++first) {
    if (used[first]) continue;
    Loop& loop = half.part.loops.emplace_back();
    auto& whole = half.whole.emplace_back();
    for (std::size_t r = first; !used[r]; r = next[r]) {
      used[r] = 1;
      loop.insert(loop.end(), runs[r].edges.begin(), runs[r].edges.end());
      whole.insert(whole.end(), runs[r].whole.begin(), runs[r].whole.end());
      const Vec2 top = runs[r].edges.back().last(), bottom = runs[next[r]].edges.front().first();
      loop.push_back(make_edge(EdgeType::line, {top, bottom}, {bottom - top, bottom - top}));
      whole.push_back({-1, -1});
    }
  }
}

double area_within(const Loop& loop) {
  double sum = 0.0;
  for (const Edge& edge : loop) sum += swept_area(edge);
  return sum;
}

/// Takes over the loops that lie at x > 0 as a whole; the runs of the others.
std::vector<HalfRun> take_closed(const Part& part, double width, Half& half) {
  std::vector<HalfRun> open;
  for (int k = 0; k < static_cast<int>(part.loops.size()); ++k) {
    bool closed = false;
    for (HalfRun& run : runs_of(part, k, width, closed)) {
      if (closed) {
        half.part.loops.push_back(std::move(run.edges));
        half.whole.push_back(std::move(run.whole));
      } else {
        open.push_back(std::move(run));
      }
    }
  }
  return open;
}

}  // namespace

Half half_of(const Part& part) {
  const double width = axis_width(part);
  Half half{{part.label, {}, {}, part.file}, {}};
  join(take_closed(part, width, half), half);
  const auto outer = [](const Loop& loop) { return area_within(loop) > 0.0; };
  const auto first = std::find_if(half.part.loops.begin(), half.part.loops.end(), outer);
  if (std::count_if(half.part.loops.begin(), half.part.loops.end(), outer) != 1)
    throw base::MeshError("what of it lies at x >= 0 is not one piece");
  const auto turn = first - half.part.loops.begin();
  std::rotate(half.part.loops.begin(), first, first + 1);
  std::rotate(half.whole.begin(), half.whole.begin() + turn, half.whole.begin() + turn + 1);
  return half;
}

EdgeChoice on_half(const EdgeChoice& choice, const Half& half) {
  EdgeChoice on;
  for (const auto& loop : half.whole) {
    on.emplace_back();
    for (const auto& [l, k] : loop)
      on.back().push_back(l >= 0 && choice[static_cast<std::size_t>(l)][static_cast<std::size_t>(k)]);
  }
  return on;
}

}  // namespace reye::cad
