#include "material/finite.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

class Invariance : public testing::TestWithParam<Named> {
 protected:
  const Material& material_ = GetParam().material;
  const Tensor Q_ = rotation(2.5);
};
INSTANTIATE_TEST_SUITE_P(all, Invariance, testing::ValuesIn(finite_laws()), name_of);

// A rotation laid over the deformation must only turn the stress, and leave no trace in the plastic state.
TEST_P(Invariance, objectivity) {
  for (auto analysis : analyses) {
    const auto [state, first, F] = loaded(material_, analysis);
    PlasticState after, after_turned;
    const Tensor tau = tensor(kirchhoff(material_, analysis, F, state, &after));
    const auto turned = kirchhoff(material_, analysis, gradient(Q_ * tensor(F)), state, &after_turned);
    EXPECT_LT((tensor(turned) - Q_ * tau * Q_.transpose()).norm(), 1e-12 * tau.norm());
    EXPECT_LT((tensor(after_turned.strain) - tensor(after.strain)).norm(), 1e-14);
    EXPECT_NEAR(after_turned.accumulated, after.accumulated, 1e-14);
  }
}

// A rotation of the material before the deformation must not be seen, when the plastic state turns with it.
TEST_P(Invariance, isotropy) {
  for (auto analysis : analyses) {
    const auto [state, first, F] = loaded(material_, analysis);
    PlasticState after, after_turned, turned = state;
    turned.strain = symmetric(Q_.transpose() * tensor(state.strain) * Q_);
    const Tensor tau = tensor(kirchhoff(material_, analysis, F, state, &after));
    const auto same = kirchhoff(material_, analysis, gradient(tensor(F) * Q_), turned, &after_turned);
    EXPECT_LT((tensor(same) - tau).norm(), 1e-12 * tau.norm());
    const Tensor expected = Q_.transpose() * tensor(after.strain) * Q_;
    EXPECT_LT((tensor(after_turned.strain) - expected).norm(), 1e-14);
  }
}

// A rigid rotation of the unloaded body must cause no stress.
TEST_P(Invariance, rigid_rotation_is_stress_free) {
  for (auto analysis : analyses) EXPECT_LT(tensor(kirchhoff(material_, analysis, gradient(Q_))).norm(), 1e-14 * E);
}

}  // namespace
