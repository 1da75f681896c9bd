#include "cad/solid/solid_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reye::cad {

namespace {

constexpr int points_of_a_leaf = 8;

double distance_from_box(const base::Vec3& low, const base::Vec3& high, const base::Vec3& p) {
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).norm();
}

base::Vec3 half_of(const SizeZone& zone) {
  return zone.radius > 0.0 ? base::Vec3::Constant(zone.radius) : zone.half_widths;
}

/// Volume of the zone and of all within d of it.
double grown_volume(const SizeZone& zone, double d) {
  if (zone.radius > 0.0) return 4.0 / 3.0 * std::numbers::pi * std::pow(zone.radius + d, 3);
  const base::Vec3 w = 2.0 * zone.half_widths;
  const double faces = 2.0 * (w.x() * w.y() + w.y() * w.z() + w.z() * w.x());
  return w.prod() + d * faces + std::numbers::pi * d * d * (w.sum() + 4.0 / 3.0 * d);
}

/// The share of the box round a zone, and of all within d of it, that lies in the box of a body.
double share_within(const SolidBox& body, const SizeZone& zone, double d) {
  const base::Vec3 half = half_of(zone) + base::Vec3::Constant(d);
  double share = 1.0;
  for (int i = 0; i < 3; ++i) {
    const double low = std::max(body[i], zone.centre[i] - half[i]),
                 high = std::min(body[i + 3], zone.centre[i] + half[i]);
    share *= half[i] > 0.0 ? std::max(0.0, high - low) / (2.0 * half[i]) : 1.0;
  }
  return share;
}

}  // namespace

SolidSize::SolidSize(double far_size, double growth, std::vector<SizeZone> zones, std::vector<SizePoint> points)
    : far_(far_size), slope_(growth - 1.0), zones_(std::move(zones)), points_(std::move(points)) {
  std::erase_if(points_, [&](const SizePoint& point) { return point.size >= far_; });
  if (!points_.empty()) grow(0, static_cast<int>(points_.size()));
}

int SolidSize::grow(int begin, int end) {
  const int own = static_cast<int>(branches_.size());
  const auto first = points_.begin() + begin, last = points_.begin() + end;
  Branch branch{first->at, first->at, first->size, begin, end, -1};
  for (auto point = first; point != last; ++point) {
    branch.low = branch.low.cwiseMin(point->at);
    branch.high = branch.high.cwiseMax(point->at);
    branch.least = std::min(branch.least, point->size);
  }
  branches_.push_back(branch);
  if (end - begin <= points_of_a_leaf) return own;
  int axis = 0;
  (branch.high - branch.low).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(first, points_.begin() + middle, last,
                   [&](const SizePoint& a, const SizePoint& b) { return a.at[axis] < b.at[axis]; });
  grow(begin, middle);
  branches_[own].second = grow(middle, end);
  return own;
}

double SolidSize::operator()(const base::Vec3& p) const {
  double size = far_;
  for (const SizeZone& zone : zones_) size = std::min(size, zone.size + slope_ * zone.distance(p));
  std::vector<int> pending;
  if (!branches_.empty()) pending.push_back(0);
  while (!pending.empty()) {
    const int own = pending.back();
    const Branch& branch = branches_[own];
    pending.pop_back();
    if (branch.least + slope_ * distance_from_box(branch.low, branch.high, p) >= size) continue;
    if (branch.second >= 0) {
      pending.insert(pending.end(), {branch.second, own + 1});
      continue;
    }
    for (int k = branch.begin; k < branch.end; ++k)
      size = std::min(size, points_[k].size + slope_ * (points_[k].at - p).norm());
  }
  return size;
}

double estimated_solid_nodes(double volume, const SolidBox& box, const SolidOrder& order) {
  constexpr double nodes_per_cube = 0.6;
  const double slope = order.growth - 1.0;
  double cubes = volume / std::pow(order.far_size, 3);
  for (const SizeZone& zone : order.zones) {
    cubes += share_within(box, zone, 0.0) * grown_volume(zone, 0.0) / std::pow(zone.size, 3);
    if (!(slope > 0.0)) continue;
    for (double d = 0.0, h = zone.size; h < order.far_size && cubes < 1e12; d += h, h = zone.size + slope * d)
      cubes += share_within(box, zone, d + h) * (grown_volume(zone, d + h) - grown_volume(zone, d)) / std::pow(h, 3);
  }
  return nodes_per_cube * cubes;
}

}  // namespace reye::cad
