#include "body/turning.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "body/edges.hpp"
#include "body/motions.hpp"
#include "fem/assemble_loads.hpp"

namespace reye::body {

Eigen::Matrix2d rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return Eigen::Matrix2d{{c, -s}, {s, c}};
}

Eigen::Matrix2d rotation_rate(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return Eigen::Matrix2d{{-s, -c}, {c, -s}};
}

namespace {

/// Whether a support acts at all.
bool acts(const Support& s) { return is_rigid(s) || s.x.drive != Drive::free || s.y.drive != Drive::free; }

/// Whether the supports leave a rotation free once the rotations of rigid edges are free.
bool may_rotate(const mesh::Mesh& mesh, BodyInput input) {
  for (Support& s : input.supports) {
    s.rigid = is_rigid(s);
    if (s.rotation.drive != Drive::fixed) s.rotation = {};
  }
  input.contact_boundaries.clear();
  const auto free = unheld_motions(mesh, input, false);
  return std::find(free.begin(), free.end(), "rotation") != free.end();
}

/// The force at every node turned by a quarter to the right, as a dead load appears in a frame a quarter turn later.
Vector quarter_turn(const Vector& f) {
  Vector turned(f.size());
  for (Eigen::Index i = 0; i < f.size(); i += 2) {
    turned[i] = f[i + 1];
    turned[i + 1] = -f[i];
  }
  return turned;
}

TurningLoad dead_load(Vector f) {
  Vector across = quarter_turn(f);
  return {Vector::Zero(f.size()), std::move(f), std::move(across)};
}

struct Candidate {
  std::optional<Pivot> pivot;
  std::string obstacle;  ///< support of fixed direction on a body that could turn
};

Candidate examine(const mesh::Mesh& mesh, const BodyInput& input) {
  Candidate result;
  if (input.analysis == base::Analysis::axisymmetric) return result;
  std::vector<int> acting;
  for (std::size_t s = 0; s < input.supports.size(); ++s)
    if (acts(input.supports[s])) acting.push_back(static_cast<int>(s));
  if (acting.empty()) {
    if (!input.contact_boundaries.empty()) result.pivot = Pivot{.centre = input.centre};
    return result;
  }
  const Support& first = input.supports[acting.front()];
  const bool edge = is_rigid(first),
             point = first.point_mm && first.x.drive != Drive::free && first.y.drive != Drive::free;
  if (acting.size() == 1 && (edge || point)) {
    if (edge && first.rotation.drive == Drive::fixed) return result;
    const SupportPlace place = place_support(mesh, first);
    const double hand = base::cross(place.x_axis.front(), place.y_axis.front()) < 0.0 ? -1.0 : 1.0;
    result.pivot = Pivot{acting.front(), edge, place.centre, hand};
    return result;
  }
  if (!may_rotate(mesh, input)) return result;
  for (int s : acting)
    if (!is_rigid(input.supports[s])) result.obstacle = input.supports[s].name;
  if (result.obstacle.empty()) result.obstacle = input.supports[acting.back()].name;
  return result;
}

}  // namespace

std::optional<Pivot> pivot_of(const mesh::Mesh& mesh, const BodyInput& input) {
  return input.keeps_direction ? std::nullopt : examine(mesh, input).pivot;
}

std::string keeps_direction(const mesh::Mesh& mesh, const BodyInput& input) { return examine(mesh, input).obstacle; }

std::array<int, 2> chord_nodes(const mesh::Mesh& mesh, const BodyInput& input, const Pivot& pivot) {
  std::vector<char> taken(mesh.X.size(), 0);
  for (const auto& name : input.contact_boundaries)
    for (int node : mesh::nodes_of(mesh.boundaries.at(name))) taken[node] = 1;
  if (pivot.support >= 0)
    for (int node : place_support(mesh, input.supports[pivot.support]).nodes) taken[node] = 1;
  const auto farthest = [&](const Vec2& from) {
    int best = -1;
    double most = 0.0;
    for (int node = 0; node < mesh.node_count(); ++node)
      if (const double way = (mesh.X[node] - from).norm(); !taken[node] && way > most) {
        best = node;
        most = way;
      }
    return best;
  };
  const int first = farthest(mesh.X.front());
  const int second = first < 0 ? -1 : farthest(mesh.X[first]);
  if (second < 0)
    throw base::InputError({{"body." + input.name + ".mesh", "",
                             "the body can turn, and all of its nodes are in contact: give it a finer mesh"}});
  return {first, second};
}

Vector TurningLoad::at(double angle) const { return still + std::cos(angle) * along + std::sin(angle) * across; }

Vector TurningLoad::rate(double angle) const { return std::cos(angle) * across - std::sin(angle) * along; }

Vector Turning::in_frame(const Vector& q) const { return in_frame(TwoPart(q)).high; }

Eigen::Matrix2d Turning::axes(double theta) const { return rotation(-hand * theta); }

std::vector<int> Turning::named() const {
  std::vector<int> columns{angle};
  for (int column : pivot)
    if (column >= 0) columns.push_back(column);
  for (const auto& [column, factor] : chord)
    if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
  return columns;
}

Turning Turning::part(const std::vector<int>& columns) const {
  const auto index = [&](int column) {
    return column < 0 ? -1 : static_cast<int>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  };
  Turning result = *this;
  result.angle = index(angle);
  result.pivot = {index(pivot[0]), index(pivot[1])};
  for (auto& [column, factor] : result.chord) column = index(column);
  return result;
}

double Turning::chord_of(const Vector& q) const {
  double sum = 0.0;
  for (const auto& [column, factor] : chord) sum += factor * q[column];
  return sum;
}

namespace {

/// c a + s b with the digits that a product of doubles loses.
base::ExactSum rotated(double c, const base::ExactSum& a, double s, const base::ExactSum& b) {
  const double x = c * a.sum, y = s * b.sum;
  const auto [sum, rest] = base::exact_sum(x, y);
  return base::exact_sum(sum, rest + std::fma(c, a.sum, -x) + std::fma(s, b.sum, -y) + c * a.rest + s * b.rest);
}

}  // namespace

TwoPart Turning::in_frame(TwoPart q) const {
  if (pivot[0] >= 0) {
    const Eigen::Matrix2d M = axes(q.high[angle]);
    const base::ExactSum a{q.high[pivot[0]], q.low[pivot[0]]}, b{q.high[pivot[1]], q.low[pivot[1]]};
    for (int i : {0, 1}) {
      const auto [sum, rest] = rotated(M(i, 0), a, M(i, 1), b);
      q.high[pivot[i]] = sum;
      q.low[pivot[i]] = rest;
    }
  }
  q.high[angle] = q.low[angle] = 0.0;
  return q;
}

Vector Turning::step_in_frame(const Vector& q, Vector dq) const {
  if (pivot[0] >= 0) {
    const Vec2 dw = axes(q[angle]) * of_pivot(dq) - hand * dq[angle] * rotation_rate(-hand * q[angle]) * of_pivot(q);
    for (int i : {0, 1}) dq[pivot[i]] = dw[i];
  }
  dq[angle] = 0.0;
  return dq;
}

void Turning::to_frame(double at, Eigen::Ref<Vector> forces) const {
  if (pivot[0] < 0) return;
  const Vec2 turned = axes(at) * Vec2(forces[pivot[0]], forces[pivot[1]]);
  for (int i : {0, 1}) forces[pivot[i]] = turned[i];
}

void Turning::to_axes(double at, Eigen::Ref<Vector> forces) const {
  if (pivot[0] < 0) return;
  const Vec2 turned = axes(at).transpose() * Vec2(forces[pivot[0]], forces[pivot[1]]);
  for (int i : {0, 1}) forces[pivot[i]] = turned[i];
}

void Turning::turn(const Vector& q, const Vector& forces, const Vector& rate, Eigen::Ref<Matrix> At) const {
  const double theta = q[angle];
  At.row(angle) = -rate.transpose();
  if (pivot[0] < 0) return;
  const Eigen::Matrix2d M = axes(theta), dM = -hand * rotation_rate(-hand * theta);
  Matrix of_pivot(2, At.cols());
  for (int i : {0, 1}) of_pivot.row(i) = At.row(pivot[i]);
  const Vec2 moved = dM * this->of_pivot(q);
  At.row(angle) += moved.transpose() * of_pivot;
  const Matrix turned_rows = M.transpose() * of_pivot;
  for (int i : {0, 1}) At.row(pivot[i]) = turned_rows.row(i);
  Matrix on_pivot(At.rows(), 2);
  for (int i : {0, 1}) on_pivot.col(i) = At.col(pivot[i]);
  const Matrix turned_columns = on_pivot * M;
  for (int i : {0, 1}) At.col(pivot[i]) = turned_columns.col(i);
  const Vec2 swung = dM.transpose() * Vec2(forces[pivot[0]], forces[pivot[1]]);
  for (int i : {0, 1}) At(angle, pivot[i]) += swung[i];
}

TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BoundaryLoad& load) {
  fem::BoundaryLoad pressure = load, dead = load;
  pressure.traction_MPa.setZero();
  dead.pressure_MPa = 0.0;
  TurningLoad nodal = dead_load(fem::load_vector(mesh, analysis, dead));
  nodal.still = fem::load_vector(mesh, analysis, pressure);
  return nodal;
}

TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::PointLoad& load) {
  return dead_load(fem::load_vector(mesh, analysis, load));
}

TurningLoad nodal_load(const mesh::Mesh& mesh, base::Analysis analysis, const fem::BodyForce& load) {
  return dead_load(fem::load_vector(mesh, analysis, load));
}

}  // namespace reye::body
