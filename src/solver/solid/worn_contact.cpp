#include "solver/solid/worn_contact.hpp"

#include <algorithm>

namespace reye::solver {

namespace {

/// What the laws of wear need to know of a point before the increment.
wear::Start start_of(const contact::SkinPlace& place, const contact::SkinWear& before,
                     const contact::SkinWearing& wearing, const contact::SkinOpenings& openings,
                     const Vector& primary_area, std::size_t j) {
  wear::Start start{.jump = wearing.jump,
                    .duration_s = wearing.duration_s,
                    .energy = before.energy[j],
                    .area = place.area[static_cast<Eigen::Index>(j)],
                    .path = before.slip[j],
                    .cycle = wearing.cycle};
  start.depth_secondary = before.moved_secondary[j] + before.pending_secondary[j] / start.area;
  start.depth_primary = openings.depth_faced(static_cast<int>(j), before, primary_area);
  return start;
}

std::vector<double> volumes(const std::vector<contact::SkinWorn>& worn, auto side) {
  std::vector<double> v;
  for (const auto& w : worn) v.push_back((w.*side).volume);
  return v;
}

}  // namespace

WornContact worn_contact(const contact::SkinSetup& setup, const contact::SkinPlace& place,
                         const contact::SkinWear& before, const contact::SkinWearing& wearing) {
  WornContact contact{contact::SkinOpenings(setup, place), {}, {}};
  contact.opened_before = contact.openings.by_volumes(before.pending_secondary, before.pending_primary) +
                          Eigen::Map<const Vector>(before.fit.data(), static_cast<Eigen::Index>(before.fit.size()));
  if (!wearing.ahead_secondary.empty())
    contact.opened_before += contact.openings.by_volumes(wearing.ahead_secondary, wearing.ahead_primary);
  return contact;
}

void wear_points(const contact::SkinSetup& setup, const contact::SkinPlace& place, const contact::SkinWear& before,
                 const contact::SkinWearing& wearing, const std::vector<char>& wears,
                 std::vector<contact::SkinNode>& nodes, WornContact& contact) {
  contact.worn.assign(nodes.size(), {});
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    // At no pressure, as where a point has just closed, there is no wear yet, but its derivative is there.
    if (!wears[j] || !(contact::pressure(nodes[j], place.frame[j]) >= 0.0)) continue;
    contact.worn[j] =
        contact::worn_at(setup.options.wear, nodes[j], place.frame[j], place.covered[static_cast<Eigen::Index>(j)],
                         start_of(place, before, wearing, contact.openings, setup.primary_area, j));
  }
  if (!setup.options.implicit_wear) return;
  const auto as_vector = [](const std::vector<double>& v) {
    return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
  };
  const auto secondary = volumes(contact.worn, &contact::SkinWorn::secondary);
  const auto primary = volumes(contact.worn, &contact::SkinWorn::primary);
  const Vector opened =
      contact.openings.per_secondary() * as_vector(secondary) + contact.openings.per_primary() * as_vector(primary);
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    const auto k = static_cast<int>(j);
    const base::Vec3& normal = place.frame[j].normal;
    nodes[j].gap += opened[k];
    nodes[j].own_wear =
        std::max(0.0, contact.openings.per_secondary().coeff(k, k) * contact.worn[j].secondary.of_traction.dot(normal) +
                          contact.openings.per_primary().coeff(k, k) * contact.worn[j].primary.of_traction.dot(normal));
  }
}

void add_wear_rows(const contact::SkinSetup& setup, const WornContact& contact, int number,
                   const std::vector<int>& normal_row, std::vector<WearRow>& rows) {
  if (!setup.options.implicit_wear) return;
  const auto add = [&](int j, const contact::SkinWorn::Side& side, const Eigen::SparseMatrix<double>& openings) {
    if (side.of_traction.isZero(0.0) && side.of_motion.isZero(0.0)) return;
    WearRow row{number, j, side.of_traction, side.of_motion, {}};
    for (Eigen::SparseMatrix<double>::InnerIterator it(openings, j); it; ++it)
      if (const auto i = static_cast<std::size_t>(it.row()); normal_row[i] >= 0)
        row.opens.emplace_back(normal_row[i], setup.stiffness[i] * it.value());
    rows.push_back(std::move(row));
  };
  const Eigen::SparseMatrix<double> of_secondary = contact.openings.per_secondary();
  const Eigen::SparseMatrix<double> of_primary = contact.openings.per_primary();
  for (int j = 0; j < static_cast<int>(contact.worn.size()); ++j) {
    add(j, contact.worn[static_cast<std::size_t>(j)].secondary, of_secondary);
    add(j, contact.worn[static_cast<std::size_t>(j)].primary, of_primary);
  }
}

}  // namespace reye::solver
