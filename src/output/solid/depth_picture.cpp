#include "output/solid/depth_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/formatted.hpp"

namespace reye::output {

namespace {

constexpr double dots_per_pixel = 2.0;

using RasterPoint = std::array<int, 2>;

/// A side of a dot on the border of its colour.
struct BorderSide {
  int colour;
  RasterPoint from, to;
  auto operator<=>(const BorderSide&) const = default;
};

/// The points of a chain that stay when what departs less than `least` from a straight line is left out.
void keep_bends(const std::vector<RasterPoint>& x, std::size_t first, std::size_t last, double least,
                std::vector<char>& kept) {
  const Vec2 a(x[first][0], x[first][1]), b(x[last][0], x[last][1]);
  const double length = (b - a).norm();
  double most = least;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 p = Vec2(x[i][0], x[i][1]) - a;
    const double off = length > 0.0 ? std::abs(p.x() * (b - a).y() - p.y() * (b - a).x()) / length : p.norm();
    if (off <= most) continue;
    most = off;
    at = i;
  }
  if (at == first) return;
  kept[at] = 1;
  keep_bends(x, first, at, least, kept);
  keep_bends(x, at, last, least, kept);
}

/// A closed chain of sides without the steps of the raster, in half dots: through the middles of sides, which lie
/// closer to a slanted border than their ends.
std::vector<RasterPoint> straightened(const std::vector<RasterPoint>& chain) {
  constexpr double least = 2.1;
  std::vector<RasterPoint> loop;
  for (std::size_t i = 0; i <= chain.size(); ++i) {
    const auto &a = chain[i % chain.size()], &b = chain[(i + 1) % chain.size()];
    loop.push_back({a[0] + b[0], a[1] + b[1]});
  }
  std::vector<char> kept(loop.size(), 0);
  const std::size_t half = loop.size() / 2;
  kept.front() = kept[half] = 1;
  keep_bends(loop, 0, half, least, kept);
  keep_bends(loop, half, loop.size() - 1, least, kept);
  std::vector<RasterPoint> bends;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
    if (kept[i]) bends.push_back(loop[i]);
  return bends;
}

/// Joins the sides of one colour, sorted by their beginnings, to closed chains.
std::vector<std::vector<RasterPoint>> chains_of(const std::vector<BorderSide>& sides) {
  std::vector<char> used(sides.size(), 0);
  std::vector<std::vector<RasterPoint>> chains;
  for (std::size_t start = 0; start < sides.size(); ++start) {
    std::vector<RasterPoint> chain;
    for (std::size_t at = start; at < sides.size() && !used[at];) {
      used[at] = 1;
      chain.push_back(sides[at].from);
      const auto next = std::lower_bound(sides.begin(), sides.end(), BorderSide{sides[at].colour, sides[at].to, {}});
      at = static_cast<std::size_t>(next - sides.begin());
      while (at < sides.size() && used[at] && sides[at].from == next->from) ++at;
      if (at < sides.size() && sides[at].from != next->from) break;
    }
    if (chain.size() > 3) chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace

DepthPicture::DepthPicture(const SpaceView& view)
    : view_(view),
      wide_(static_cast<int>(std::ceil(dots_per_pixel * view.field.size().x()))),
      high_(static_cast<int>(std::ceil(dots_per_pixel * view.field.size().y()))),
      dots_(static_cast<std::size_t>(wide_) * static_cast<std::size_t>(high_)) {}

Vec3 DepthPicture::on_raster(const Vec3& x) const {
  const Vec2 p = dots_per_pixel * (view_.pixel(x) - view_.field.low);
  return {p.x(), p.y(), view_.nearness(x)};
}

void DepthPicture::add(const Points3& corners, const std::string& colour) {
  auto found = std::find(colours_.begin(), colours_.end(), colour);
  if (found == colours_.end()) found = colours_.insert(colours_.end(), colour);
  const int index = static_cast<int>(found - colours_.begin());
  for (std::size_t k = 2; k < corners.size(); ++k)
    fill(on_raster(corners[0]), on_raster(corners[k - 1]), on_raster(corners[k]), index);
}

void DepthPicture::fill(const Vec3& a, const Vec3& b, const Vec3& c, int colour) {
  const double area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  if (!(std::abs(area) > 1e-9)) return;
  const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
  const auto [top, bottom] = std::minmax({a.y(), b.y(), c.y()});
  const auto dot = [](double x, int end) { return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(end))); };
  constexpr double rim = -1e-6;  // a dot on the edge between two facets belongs to one of them at least
  for (int j = dot(std::floor(top), high_); j < dot(std::ceil(bottom) + 1.0, high_); ++j)
    for (int i = dot(std::floor(left), wide_); i < dot(std::ceil(right) + 1.0, wide_); ++i) {
      const double x = i + 0.5, y = j + 0.5;
      const double u = ((b.x() - x) * (c.y() - y) - (b.y() - y) * (c.x() - x)) / area;
      const double v = ((c.x() - x) * (a.y() - y) - (c.y() - y) * (a.x() - x)) / area;
      if (u < rim || v < rim || 1.0 - u - v < rim) continue;
      const auto nearness = static_cast<float>(u * a.z() + v * b.z() + (1.0 - u - v) * c.z());
      Dot& held = dots_[static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i)];
      if (nearness > held.nearness) held = {nearness, colour};
    }
}

bool DepthPicture::sees(const Vec3& x) const {
  const Vec3 p = on_raster(x);
  const int i = static_cast<int>(std::floor(p.x())), j = static_cast<int>(std::floor(p.y()));
  if (i < 0 || j < 0 || i >= wide_ || j >= high_) return false;
  const double slack = 4.0 / (dots_per_pixel * view_.pixels_per_mm);
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      const int k = std::clamp(i + di, 0, wide_ - 1), l = std::clamp(j + dj, 0, high_ - 1);
      const Dot& held =
          dots_[static_cast<std::size_t>(l) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(k)];
      if (static_cast<double>(held.nearness) <= p.z() + slack) return true;
    }
  return false;
}

int DepthPicture::colour_at(int i, int j) const {
  if (i < 0 || j < 0 || i >= wide_ || j >= high_) return -1;
  return dots_[static_cast<std::size_t>(j) * static_cast<std::size_t>(wide_) + static_cast<std::size_t>(i)].colour;
}

std::string DepthPicture::svg() const {
  std::vector<std::vector<BorderSide>> sides(colours_.size());
  for (int j = 0; j < high_; ++j)
    for (int i = 0; i < wide_; ++i) {
      const int own = colour_at(i, j);
      if (own < 0) continue;
      auto& list = sides[static_cast<std::size_t>(own)];
      if (colour_at(i, j - 1) != own) list.push_back({own, {i, j}, {i + 1, j}});
      if (colour_at(i + 1, j) != own) list.push_back({own, {i + 1, j}, {i + 1, j + 1}});
      if (colour_at(i, j + 1) != own) list.push_back({own, {i + 1, j + 1}, {i, j + 1}});
      if (colour_at(i - 1, j) != own) list.push_back({own, {i, j + 1}, {i, j}});
    }
  std::string out;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    std::sort(sides[k].begin(), sides[k].end());
    std::string path;
    for (const auto& chain : chains_of(sides[k])) {
      char pen = 'M';
      for (const auto& p : straightened(chain)) {
        path += pen + base::fixed(view_.field.low.x() + 0.5 * p[0] / dots_per_pixel, 1) + ' ' +
                base::fixed(view_.field.low.y() + 0.5 * p[1] / dots_per_pixel, 1);
        pen = 'L';
      }
      path += 'Z';
    }
    if (!path.empty())
      out += "<path d=\"" + path + "\" fill=\"" + colours_[k] + "\" fill-rule=\"evenodd\" stroke=\"" + colours_[k] +
             "\" stroke-width=\"0.8\"/>\n";
  }
  return out;
}

}  // namespace reye::output
