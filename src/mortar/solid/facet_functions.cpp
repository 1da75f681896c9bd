#include "mortar/solid/facet_functions.hpp"

#include <cmath>
#include <vector>

namespace reye::mortar {

namespace {

using mesh::FacetKind;

constexpr double w6_1 = 0.11678627572637936603, a6_1 = 0.24928674517091042129;
constexpr double w6_2 = 0.050844906370206816921, a6_2 = 0.06308901449150222834;
constexpr double w6_3 = 0.082851075618373575194, a6_3 = 0.053145049844816947353, b6_3 = 0.31035245103378440542;

constexpr double w8_0 = 0.14431560767778716825, w8_1 = 0.095091634267284624794, a8_1 = 0.45929258829272315603;
constexpr double w8_2 = 0.10321737053471825028, a8_2 = 0.17056930775176020662;
constexpr double w8_3 = 0.032458497623198080311, a8_3 = 0.050547228317030975458;
constexpr double w8_4 = 0.027230314174434994265, a8_4 = 0.0083947774099576053372, b8_4 = 0.26311282963463811342;

/// The three places (a, a), (1 - 2a, a), (a, 1 - 2a).
void add_three(std::vector<RulePlace>& rule, double weight, double a) {
  rule.push_back({{a, a}, weight});
  rule.push_back({{1.0 - 2.0 * a, a}, weight});
  rule.push_back({{a, 1.0 - 2.0 * a}, weight});
}

/// The six places (a, b), (b, a), (a, c) ... with c = 1 - a - b.
void add_six(std::vector<RulePlace>& rule, double weight, double a, double b) {
  const std::array<double, 3> c{a, b, 1.0 - a - b};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j) rule.push_back({{c[i], c[j]}, weight});
}

std::vector<RulePlace> degree2() {
  std::vector<RulePlace> rule;
  add_three(rule, 1.0 / 3.0, 1.0 / 6.0);
  return rule;
}

std::vector<RulePlace> degree5() {
  const double root = std::sqrt(15.0);
  std::vector<RulePlace> rule{{{1.0 / 3.0, 1.0 / 3.0}, 0.225}};
  add_three(rule, (155.0 - root) / 1200.0, (6.0 - root) / 21.0);
  add_three(rule, (155.0 + root) / 1200.0, (6.0 + root) / 21.0);
  return rule;
}

std::vector<RulePlace> degree6() {
  std::vector<RulePlace> rule;
  add_three(rule, w6_1, a6_1);
  add_three(rule, w6_2, a6_2);
  add_six(rule, w6_3, a6_3, b6_3);
  return rule;
}

std::vector<RulePlace> degree8() {
  std::vector<RulePlace> rule{{{1.0 / 3.0, 1.0 / 3.0}, w8_0}};
  add_three(rule, w8_1, a8_1);
  add_three(rule, w8_2, a8_2);
  add_three(rule, w8_3, a8_3);
  add_six(rule, w8_4, a8_4, b8_4);
  return rule;
}

std::vector<RulePlace> square() {
  const std::array<double, 3> at{-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  std::vector<RulePlace> rule;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) rule.push_back({{at[i], at[j]}, weight[i] * weight[j]});
  return rule;
}

std::vector<RulePlace> halved(std::span<const RulePlace> rule) {
  std::vector<RulePlace> half(rule.begin(), rule.end());
  for (auto& place : half) place.weight *= 0.5;
  return half;
}

}  // namespace

Vec2 reference_place(FacetKind kind, int j) {
  static const std::array<Vec2, 6> triangle{Vec2{0, 0},   Vec2{1, 0},     Vec2{0, 1},
                                            Vec2{0.5, 0}, Vec2{0.5, 0.5}, Vec2{0, 0.5}};
  static const std::array<Vec2, 4> quadrangle{Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}};
  return kind == FacetKind::quad4 ? quadrangle[j] : triangle[j];
}

std::span<const RulePlace> triangle_rule(int degree) {
  static const std::vector<RulePlace> two = degree2(), five = degree5(), six = degree6(), eight = degree8();
  if (degree <= 2) return two;
  return degree <= 5 ? five : degree <= 6 ? six : eight;
}

std::span<const RulePlace> facet_rule(FacetKind kind) {
  static const std::vector<RulePlace> tri3 = halved(triangle_rule(2)), quad4 = square(),
                                      tri6 = halved(triangle_rule(6));
  return kind == FacetKind::tri3 ? tri3 : kind == FacetKind::quad4 ? quad4 : tri6;
}

}  // namespace reye::mortar
