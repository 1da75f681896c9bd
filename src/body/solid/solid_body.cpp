#include "body/solid/solid_body.hpp"

#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "body/solid/elastic_solid.hpp"
#include "body/solid/solid_conflicts.hpp"
#include "mesh/solid/solid_measure.hpp"

namespace reye::body {

namespace {

/// Supports that contradict each other would be dropped in silence.
void refuse_conflicts(const SolidInput& input) {
  std::vector<base::Issue> issues;
  for (const auto& conflict : solid_support_conflicts(input)) {
    if (!conflict.refused) continue;
    const std::string key = "support." + input.supports[conflict.support].name;
    issues.push_back({conflict.motion.empty() ? key : key + '.' + conflict.motion, "", conflict.text});
  }
  if (!issues.empty()) throw base::InputError(std::move(issues));
}

}  // namespace

struct SolidBody::Impl {
  SolidInput input;
  std::vector<int> retained;
  std::vector<SolidPlace> places;  ///< of the supports
  SolidMatrices matrices;
  std::optional<ElasticSolid> elastic;
  RigidMotion rigid;

  Impl(SolidInput given, std::vector<int> nodes, std::optional<algebra::SchurFactor> spare)
      : input(std::move(given)), retained(std::move(nodes)) {
    refuse_conflicts(input);
    for (const auto& support : input.supports) places.push_back(place_support(*input.mesh, support));
    matrices.driven = driven_of(input);
    matrices.centre = mesh::box_centre(input.mesh->X);
    for (const auto& load : input.loads) matrices.load_resultant.push_back(resultant_of(input, load, matrices.centre));
    if (input.rigid)
      rigid = condense_rigid(input, places, retained, matrices);
    else
      elastic.emplace(input, places, retained, std::move(spare), matrices);
  }

  Points3 rigid_displacements(const Vector& f, const Vector& s, const Vector& a) const {
    const Mode z = rigid.of_f * f + rigid.of_s * s + matrices.modes * a;
    Points3 u;
    u.reserve(input.mesh->X.size());
    for (const Vec3& X : input.mesh->X) u.push_back(modes_at(X, matrices.centre) * z);
    return u;
  }
};

SolidBody::SolidBody(SolidInput input, std::vector<int> retained, std::optional<algebra::SchurFactor> spare)
    : impl_(std::make_unique<Impl>(std::move(input), std::move(retained), std::move(spare))) {}
SolidBody::~SolidBody() = default;
SolidBody::SolidBody(SolidBody&&) noexcept = default;
SolidBody& SolidBody::operator=(SolidBody&&) noexcept = default;

const SolidInput& SolidBody::input() const { return impl_->input; }
const std::vector<int>& SolidBody::retained() const { return impl_->retained; }
const std::vector<Driven>& SolidBody::driven() const { return impl_->matrices.driven; }
const PointCompliance& SolidBody::C() const { return impl_->matrices.C; }
const Matrix& SolidBody::U() const { return impl_->matrices.U; }
const Matrix& SolidBody::A() const { return impl_->matrices.A; }
const Matrix& SolidBody::B() const { return impl_->matrices.B; }
const Matrix& SolidBody::F() const { return impl_->matrices.F; }
const Matrix& SolidBody::G() const { return impl_->matrices.G; }
const Vec3& SolidBody::centre() const { return impl_->matrices.centre; }
const std::vector<Mode>& SolidBody::load_resultant() const { return impl_->matrices.load_resultant; }
Vec3 SolidBody::support_centre(int support) const { return impl_->places[static_cast<std::size_t>(support)].centre; }

std::vector<std::string> SolidBody::free_motions() const {
  std::vector<std::string> names;
  for (int k = 0; k < impl_->matrices.modes.cols(); ++k) names.push_back(mode_name(impl_->matrices.modes.col(k)));
  return names;
}

Points3 SolidBody::displacements(const Vector& f, const Vector& s, const Vector& a) const {
  return impl_->elastic ? impl_->elastic->displacements(impl_->matrices, impl_->retained, f, s, a)
                        : impl_->rigid_displacements(f, s, a);
}

Points3 SolidBody::displacements_in(std::shared_ptr<const mesh::SolidMesh> shape, const Vector& f, const Vector& s,
                                    const Vector& a) const {
  SolidInput input = impl_->input;
  input.mesh = std::move(shape);
  if (impl_->elastic) {
    std::vector<SolidPlace> places;
    for (const auto& support : input.supports) places.push_back(place_support(*input.mesh, support));
    if (auto u = impl_->elastic->displacements_in(input, places, impl_->retained, impl_->matrices, f, s, a))
      return std::move(*u);
  }
  return SolidBody(std::move(input), impl_->retained).displacements(f, s, a);
}

std::optional<algebra::SchurFactor> SolidBody::take_factor() {
  if (!impl_->elastic) return {};
  return impl_->elastic->take_factor();
}

}  // namespace reye::body
