#include "material/parameters.hpp"

namespace reye::material {

double young(const Material& material) {
  return std::visit([](const auto& m) { return m.E_MPa; }, material);
}

double poisson(const Material& material) {
  return std::visit([](const auto& m) { return m.nu; }, material);
}

double shear_modulus(const Material& material) {
  return std::visit([](const auto& m) { return shear_modulus(m); }, material);
}

double bulk_modulus(const Material& material) {
  return std::visit([](const auto& m) { return bulk_modulus(m); }, material);
}

bool has_history(const Material& material) { return std::holds_alternative<HenckyJ2>(material); }

bool supports(const Material& material, base::Kinematics kinematics) {
  return kinematics == base::Kinematics::small || !std::holds_alternative<LinearElastic>(material);
}

}  // namespace reye::material
