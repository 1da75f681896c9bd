#include "material/finite.hpp"
#include "material/laws.hpp"

namespace {

using namespace reye;
using namespace reye::material;
using namespace reye::material::test;
using base::Analysis;

const Gradient<double> directions[] = {{0.3, -0.4, 0.8, 0.5, -0.6}, {-0.2, 0.9, 0.1, -0.7, 0.4}};

class Tangent : public testing::TestWithParam<Named> {
 protected:
  void expect_rate(Analysis analysis, const Gradient<double>& F, const PlasticState& state) const {
    const auto& material = GetParam().material;
    const auto P = [&](const auto& x) { return first_piola(material, analysis, x, state); };
    for (const auto& d : directions) EXPECT_NEAR(linearisation_rate(P, F, d), 2.0, 0.02);
  }
};
INSTANTIATE_TEST_SUITE_P(all, Tangent, testing::ValuesIn(finite_laws()), name_of);

// The derivative by dual numbers must be that of the stress: the remainder falls at rate 2, in plastic loading too.
TEST_P(Tangent, general_state) {
  for (auto analysis : analyses) {
    const auto [state, F, next] = loaded(GetParam().material, analysis);
    expect_rate(analysis, next, state);
  }
}

// The tangent must be exact where in-plane eigenvalues are equal: undeformed, inflated, and inflated far into the
// plastic range.
TEST_P(Tangent, equal_eigenvalues) {
  for (auto analysis : analyses)
    for (const Gradient<double>& F : {Gradient<double>{1, 0, 0, 1, 1}, {1.1, 0, 0, 1.1, 1.0}, {0, -1.2, 1.2, 0, 0.8}})
      expect_rate(analysis, F, {});
}

}  // namespace
