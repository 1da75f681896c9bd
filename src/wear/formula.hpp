#pragma once
#include <memory>
#include <stdexcept>
#include <string>

/// Formulas of a scene, for coefficients of wear and friction.
namespace reye::wear {

/// A text that is no formula, or a formula without a usable value.
class FormulaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a formula may depend on, at one place of a contact.
enum class Variable { pressure, speed, path, depth, cycle };

/// Values of these variables; formulas name them as the comments do.
struct Place {
  double pressure = 0.0;  ///< pressure_MPa
  double speed = 0.0;     ///< speed_mm_per_s, of the slip
  double path = 0.0;      ///< path_mm, of the slip since the start, at the node of the secondary side
  double depth = 0.0;     ///< depth_mm, worn since the start: of the side whose coefficient it is, or of the secondary
  double cycle = 0.0;     ///< cycles before the block

  double& at(Variable variable);
};

/// Below these, pressure and speed count as these: a power of them keeps a finite slope.
inline constexpr double least_pressure_MPa = 1e-6, least_speed_mm_per_s = 1e-9;

/// An expression as a scene writes it; parsed once, cheap to copy. An empty one stands for none.
class Formula {
 public:
  Formula() = default;
  /// Throws FormulaError with the reason and the place in the text where it is not a formula of the variables.
  explicit Formula(const std::string& text);

  explicit operator bool() const { return static_cast<bool>(parsed_); }
  const std::string& text() const;
  bool uses(Variable variable) const;

  /// Its value; throws FormulaError, with the place, where that is negative or not finite. Pressure and speed are
  /// raised to their least values.
  double at(Place place) const;

  /// Its derivative, by a stencil of four points at 0.1 and 0.2 % of the variable, exact to some 1e-12 of value over
  /// variable where the formula is smooth; zero where the variable is at or below its least value.
  double slope(Place place, Variable variable) const;

 private:
  struct Parsed;
  std::shared_ptr<const Parsed> parsed_;
};

/// Why a text is not a formula that can be used; empty when it is. Beside its grammar its values at the start of a
/// contact's life are looked at: path, depth and cycle zero, pressures of 1 and 100 MPa, speeds of 1 and 100 mm/s.
std::string broken_formula(const std::string& text);

/// The largest of these values.
double at_start(const Formula& formula);

}  // namespace reye::wear
