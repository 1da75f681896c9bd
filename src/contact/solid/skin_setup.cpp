#include "contact/solid/skin_setup.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/solid/facet_control_points.hpp"
#include "mesh/solid/solid_measure.hpp"
#include "mortar/solid/facet_geometry.hpp"

namespace reye::contact {

namespace {

using base::Points3;

/// Numbers points as facets ask for them.
class SideBuilder {
 public:
  SideBuilder(const std::vector<const mesh::SolidMesh*>& meshes, const Columns& columns)
      : meshes_(meshes), columns_(columns) {}

  void add(const FaceRef& ref) {
    const auto& mesh = *meshes_[ref.body];
    const auto& controls = controls_of(ref.body);
    for (const int index : mesh.faces.at(ref.face)) {
      const auto& facet = mesh.skin[index];
      if (!kept(ref.body, facet)) {
        left_out_.push_back({ref.body, facet});
        continue;
      }
      mesh::Facet own = facet;
      for (int k = 0; k < facet.count(); ++k) own.nodes[k] = point(ref.body, facet.nodes[k], controls);
      side_.skin.facets.push_back(own);
    }
  }

  SkinSide take() {
    side_.rim.assign(side_.points.size(), 0);
    for (const auto& [body, facet] : left_out_)
      for (int k = 0; k < facet.count(); ++k)
        if (const auto found = numbers_.find({body, facet.nodes[k]}); found != numbers_.end())
          side_.rim[found->second] = 1;
    return std::move(side_);
  }

 private:
  bool kept(int body, const mesh::Facet& facet) const {
    return std::all_of(facet.nodes.begin(), facet.nodes.begin() + facet.count(),
                       [&](int node) { return columns_[body][node] >= 0; });
  }

  const Points3& controls_of(int body) {
    auto [entry, fresh] = controls_.try_emplace(body);
    if (fresh) entry->second = mesh::control_points(meshes_[body]->skin, meshes_[body]->X);
    return entry->second;
  }

  int point(int body, int node, const Points3& controls) {
    const auto [entry, fresh] = numbers_.try_emplace({body, node}, static_cast<int>(side_.points.size()));
    if (fresh) {
      side_.points.push_back({body, node, columns_[body][node]});
      side_.skin.x.push_back(controls[node]);
    }
    return entry->second;
  }

  const std::vector<const mesh::SolidMesh*>& meshes_;
  const Columns& columns_;
  std::map<int, Points3> controls_;
  std::map<std::pair<int, int>, int> numbers_;
  std::vector<std::pair<int, mesh::Facet>> left_out_;
  SkinSide side_;
};

/// Lebesgue's curve: the bits of the three places in the box of all points, taken in turn.
std::vector<int> along_a_curve(const Points3& x) {
  constexpr int bits = 10;
  Eigen::AlignedBox3d box;
  for (const auto& point : x) box.extend(point);
  std::vector<std::pair<unsigned, int>> keys;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const base::Vec3 share = (x[j] - box.min()) / std::max(box.sizes().maxCoeff(), 1e-300);
    const Eigen::Vector3i cell = (share * ((1 << bits) - 1)).cast<int>();
    unsigned key = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
      for (int axis = 0; axis < 3; ++axis) key = 2 * key + ((static_cast<unsigned>(cell[axis]) >> bit) & 1U);
    keys.emplace_back(key, static_cast<int>(j));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order;
  for (const auto& [key, point] : keys) order.push_back(point);
  return order;
}

}  // namespace

SkinSide make_side(const std::vector<FaceRef>& faces, const std::vector<const mesh::SolidMesh*>& meshes,
                   const Columns& columns) {
  SideBuilder builder(meshes, columns);
  for (const auto& face : faces) builder.add(face);
  return builder.take();
}

SkinSetup make_skin_setup(const SkinContactOptions& options, SkinSide secondary, SkinSide primary, double modulus_MPa,
                          double search) {
  SkinSetup setup{options, std::move(secondary), std::move(primary), {}, {}, search, {}};
  setup.primary_area = mortar::nodal_areas(setup.primary.skin);
  const auto& skin = setup.secondary.skin;
  setup.order = along_a_curve(skin.x);
  std::vector<double> longest(skin.x.size(), 0.0);
  for (const auto& facet : skin.facets) {
    const double size = std::sqrt(mesh::facet_area(skin.x, facet));
    for (int k = 0; k < facet.count(); ++k) longest[facet.nodes[k]] = std::max(longest[facet.nodes[k]], size);
  }
  for (const double size : longest) setup.stiffness.push_back(modulus_MPa / size);
  return setup;
}

}  // namespace reye::contact
